#include "renderer/command_line/completion.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "renderer/base/text/words.h"

namespace foveola {
namespace {

constexpr const char* bash_script = R"(# bash completion of PROGRAM
_PROGRAM() {
  local word rest current=${COMP_WORDS[COMP_CWORD]}
  COMPREPLY=()
  while IFS=$'\t' read -r word rest; do
    if [[ $word != / ]]; then
      COMPREPLY+=("$word")
    else
      # The shell takes quotes and backslashes for part of the word.
      current=${current#[\"\'=]}
      mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -f -- "${current//\\/}")
      compopt -o filenames 2>/dev/null
    fi
  done < <("${COMP_WORDS[0]}" __complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
}
complete -F _PROGRAM PROGRAM
)";

/// Its last line: it is read by `source`, or is the body of the function named after the file, at
/// its first call.
constexpr const char* zsh_script = R"(#compdef PROGRAM
_PROGRAM() {
  local line
  local -a found
  for line in "${(@f)$(${(Q)words[1]} __complete "${(@Q)words[2,CURRENT]}" 2>/dev/null)}"; do
    case $line in
      '') ;;
      /) compset -P '--*='; _files ;;
      *) found+=("${${line//:/\\:}/$'\t'/:}") ;;
    esac
  done
  _describe PROGRAM found
}
if [ "$funcstack[1]" = _PROGRAM ]; then
  _PROGRAM "$@"
else
  compdef _PROGRAM PROGRAM
fi
)";

constexpr const char* fish_script = R"(# fish completion of PROGRAM
function __PROGRAM_complete
    set -l current (commandline -ct)
    set -l words (commandline -opc) "$current"
    for line in (command $words[1] __complete $words[2..-1] 2>/dev/null)
        if test "$line" = /
            __fish_complete_path "$current"
        else
            echo $line
        end
    end
end
complete -c PROGRAM -f -a '(__PROGRAM_complete)'
)";

constexpr std::array scripts{Word<const char*>{"bash", bash_script},
                             Word<const char*>{"zsh", zsh_script},
                             Word<const char*>{"fish", fish_script}};

/// The candidates for one place.
struct Candidates {
  std::vector<std::pair<std::string, std::string>> words;  ///< with their descriptions
  bool has_files = false;

  /// Adds those of a value.
  void add_values(const OptionDescription& option) {
    for (const std::string& choice : option.choices) {
      words.emplace_back(choice, "");
    }
    has_files = has_files || may_take_file(option);
  }
};

/// The command named by all words except the last; null if there is none.
const CommandDescription* find_command(const CommandDescription& program,
                                       const std::vector<std::string>& words) {
  const CommandDescription* command = &program;
  for (auto word = words.begin(); word + 1 != words.end() && !command->commands.empty(); ++word) {
    if (!word->starts_with('-')) {
      const auto inner = std::ranges::find(command->commands, *word, &CommandDescription::name);
      if (inner == command->commands.end()) {
        return nullptr;
      }
      command = &*inner;
    }
  }
  return command;
}

/// Null if the command has no such option with a value.
const OptionDescription* find_valued_option(const CommandDescription& command,
                                            const std::string& name) {
  const auto option = std::ranges::find_if(command.options, [&](const OptionDescription& known) {
    return !known.value_name.empty() && std::ranges::find(known.names, name) != known.names.end();
  });
  return option != command.options.end() ? &*option : nullptr;
}

Candidates candidates_for(const CommandDescription& command,
                          const std::vector<std::string>& words) {
  Candidates found;
  const OptionDescription* option =
      words.size() > 1 ? find_valued_option(command, words[words.size() - 2]) : nullptr;
  if (option != nullptr) {
    found.add_values(*option);
  } else if (words.back().starts_with('-')) {
    for (const OptionDescription& known : command.options) {
      for (const std::string& name : known.names) {
        found.words.emplace_back(name, first_clause(known.description));
      }
    }
  } else {
    for (const OptionDescription& positional : command.positionals) {
      found.add_values(positional);
    }
    for (const CommandDescription& inner : command.commands) {
      found.words.emplace_back(inner.name, first_clause(inner.description));
    }
  }
  return found;
}

/// Splits --option=value into two words. Returns the part of its word before the value.
std::string split_value(std::vector<std::string>& words) {
  const std::string last = words.back();
  const std::size_t equals = last.find('=');
  if (last == "=") {
    words.back().clear();
  } else if (words.size() > 1 && words[words.size() - 2] == "=") {
    words.erase(words.end() - 2);
  } else if (last.starts_with("--") && equals != std::string::npos) {
    words.back() = last.substr(0, equals);
    words.push_back(last.substr(equals + 1));
    return last.substr(0, equals + 1);
  }
  return "";
}

}  // namespace

std::string first_clause(const std::string& description) {
  std::size_t end = description.size();
  for (const char* detail : {" (", ": ", "; ", ". "}) {
    end = std::min(end, description.find(detail));
  }
  return description.substr(0, end);
}

std::string completions(const CommandDescription& program, std::vector<std::string> words) {
  const std::string before = split_value(words);
  const CommandDescription* command = find_command(program, words);
  if (command == nullptr) {
    return "";
  }
  const Candidates found = candidates_for(*command, words);
  std::string lines;
  for (const auto& [word, description] : found.words) {
    if (word.starts_with(words.back())) {
      lines += before + word + (description.empty() ? "" : "\t" + description) + "\n";
    }
  }
  return found.has_files ? lines + "/\n" : lines;
}

std::string completion_script(const std::string& shell, const std::string& program) {
  constexpr std::string_view place = "PROGRAM";
  std::string script = value_of(scripts, shell);
  for (std::size_t at = script.find(place); at != std::string::npos; at = script.find(place, at)) {
    script.replace(at, place.size(), program);
  }
  return script;
}

}  // namespace foveola
