#include "renderer/command_line/completion.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace foveola {
namespace {

/// Behind a file's functions: read by `source`, or as the body of the function that it is named
/// after, when it is called first.
constexpr const char* zsh_end = R"(
if [ "$funcstack[1]" = _PROGRAM ]; then
  _PROGRAM "$@"
else
  compdef _PROGRAM PROGRAM
fi
)";

std::string zsh_quoted(const std::string& text) {
  return "'" + replaced_all(text, "'", R"('\'')") + "'";
}

/// For what _arguments and _describe take apart at colons and brackets.
std::string zsh_escaped(const std::string& text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '\\' || letter == ':' || letter == '[' || letter == ']') {
      escaped += '\\';
    }
    escaped += letter;
  }
  return escaped;
}

/// ":MESSAGE:ACTION" as _arguments has it; a lone blank is the action that completes nothing.
std::string zsh_value(const OptionDescription& option, const std::string& message) {
  std::string action = " ";
  if (!option.choices.empty()) {
    action = fmt::format("({})", fmt::join(option.choices, " "));
  } else if (may_take_file(option)) {
    action = "_files";
  }
  return fmt::format(":{}:{}", zsh_escaped(message), action);
}

/// What _arguments takes for one name of the option. None of its names is offered twice, unless it
/// takes many values.
std::string zsh_option(const OptionDescription& option, const std::string& name) {
  const std::string before =
      option.takes_many ? "*" : fmt::format("({})", fmt::join(option.names, " "));
  const bool takes_value = !option.value_name.empty();
  const bool may_be_one_word = takes_value && name.starts_with("--");
  return fmt::format("{}{}{}[{}]{}", before, name, may_be_one_word ? "=" : "",
                     zsh_escaped(first_clause(option.description)),
                     takes_value ? zsh_value(option, option.value_name) : "");
}

std::string zsh_positional(const OptionDescription& positional) {
  return (positional.takes_many ? "*" : "") + zsh_value(positional, positional.names.front());
}

/// A call of _arguments with what it completes.
std::string zsh_arguments(const CommandDescription& command) {
  std::string call = "  _arguments -C";
  const auto add = [&call](const std::string& what) { call += " \\\n    " + zsh_quoted(what); };
  for (const OptionDescription& option : command.options) {
    for (const std::string& name : option.names) {
      add(zsh_option(option, name));
    }
  }
  for (const OptionDescription& positional : command.positionals) {
    add(zsh_positional(positional));
  }
  if (!command.commands.empty()) {
    add("1: :->command");
    add("*:: :->arguments");
  }
  return call + "\n";
}

/// What follows when _arguments has come to a command, or to what is behind it.
std::string zsh_inner_commands(const CommandDescription& command, const std::string& function) {
  std::string list;
  std::string cases;
  for (const CommandDescription& inner : command.commands) {
    list += fmt::format("\n        {}", zsh_quoted(inner.name + ":" +
                                                   zsh_escaped(first_clause(inner.description))));
    cases += fmt::format("\n        {0}) {1}_{0} ;;", inner.name, function);
  }
  return fmt::format(
      "  case $state in\n"
      "    command)\n      commands=({})\n      _describe command commands ;;\n"
      "    arguments)\n      case $words[1] in{}\n      esac ;;\n"
      "  esac\n",
      list, cases);
}

/// The command's function and, before it, those of its own commands.
std::string zsh_functions(const CommandDescription& command, const std::string& function) {
  std::string functions;
  for (const CommandDescription& inner : command.commands) {
    functions += zsh_functions(inner, function + "_" + inner.name);
  }
  functions += fmt::format("\n{}() {{\n", function);
  if (command.commands.empty()) {
    return functions + zsh_arguments(command) + "}\n";
  }
  return functions + "  local curcontext=$curcontext line state\n  local -a commands\n" +
         zsh_arguments(command) + zsh_inner_commands(command, function) + "}\n";
}

/// The words that were typed, without the program's name and without options, tell the command.
constexpr const char* fish_functions = R"(# fish completion of PROGRAM

function __PROGRAM_words
    set -l words (commandline -opc)
    set -e words[1]
    for word in $words
        string match -q -- '-*' $word
        or echo $word
    end
end

# Whether these are all the words so far.
function __PROGRAM_at
    set -l words (__PROGRAM_words)
    test "$words" = "$argv"
end

# Whether these are the first of the words so far.
function __PROGRAM_in
    set -l words (__PROGRAM_words)
    set -l count (count $argv)
    test (count $words) -ge $count
    and test "$words[1..$count]" = "$argv"
end

complete -c PROGRAM -f
)";

std::string fish_quoted(const std::string& text) {
  return "'" + replaced_all(replaced_all(text, "\\", "\\\\"), "'", "\\'") + "'";
}

/// The part of a `complete` that says which values follow.
std::string fish_value(const OptionDescription& option) {
  if (!option.choices.empty()) {
    return fmt::format(" -x -a {}", fish_quoted(fmt::format("{}", fmt::join(option.choices, " "))));
  }
  return may_take_file(option) ? " -r -F" : " -x";
}

/// `complete`: the beginning of a line of the script. condition: a command of fish.
std::string fish_complete(const std::string& program, const std::string& condition) {
  return fmt::format("complete -c {} -n {}", program, fish_quoted(condition));
}

std::string fish_option(const OptionDescription& option) {
  std::string names;
  for (const std::string& name : option.names) {
    const bool is_long = name.starts_with("--");
    names += (is_long ? " -l " : " -s ") + name.substr(is_long ? 2 : 1);
  }
  return fmt::format("{}{} -d {}\n", names, option.value_name.empty() ? "" : fish_value(option),
                     fish_quoted(first_clause(option.description)));
}

std::string fish_positional(const OptionDescription& positional) {
  return may_take_file(positional)
             ? " -F\n"
             : fmt::format(" -a {}\n",
                           fish_quoted(fmt::format("{}", fmt::join(positional.choices, " "))));
}

/// The lines for a command and for its own. path: the words that name it, each behind a blank.
std::string fish_lines(const std::string& program, const CommandDescription& command,
                       const std::string& path) {
  const bool is_last = command.commands.empty();
  const std::string begin =
      fish_complete(program, fmt::format("__{}_{}{}", program, is_last ? "in" : "at", path));
  std::string lines;
  for (const OptionDescription& option : command.options) {
    lines += begin + fish_option(option);
  }
  for (const OptionDescription& positional : command.positionals) {
    lines += begin + fish_positional(positional);
  }
  for (const CommandDescription& inner : command.commands) {
    lines += fmt::format("{} -a {} -d {}\n", begin, inner.name,
                         fish_quoted(first_clause(inner.description)));
  }
  for (const CommandDescription& inner : command.commands) {
    lines += fish_lines(program, inner, path + " " + inner.name);
  }
  return lines;
}

/// What goes through the words. Its variables are those of the functions that it calls, which are
/// the tables.
constexpr const char* bash_function = R"(
_PROGRAM() {
  local IFS=$' \t\n' current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  # Of --option=value bash makes three words.
  if [[ $current == = ]]; then
    current=
  elif [[ $previous == = ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  local command=PROGRAM word commands options words files
  COMPREPLY=()
  _PROGRAM_command "$command"
  for word in "${COMP_WORDS[@]:1:COMP_CWORD - 1}"; do
    if [[ ${#commands[@]} -eq 0 ]]; then
      break
    elif [[ $word != -* ]]; then
      command+=" $word"
      _PROGRAM_command "$command" || return 0
    fi
  done
  if ! _PROGRAM_value "$command $previous"; then
    if [[ $current == -* ]]; then
      words=("${options[@]}") files=
    else
      words+=("${commands[@]}")
    fi
  fi
  for word in "${words[@]}"; do
    if [[ $word == "$current"* ]]; then
      COMPREPLY+=("$word")
    fi
  done
  if [[ -n $files ]]; then
    # The shell takes quotes and backslashes for part of the word.
    current=${current#[\"\']}
    mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen -f -- "${current//\\/}")
    compopt -o filenames 2>/dev/null
  fi
}

complete -F _PROGRAM PROGRAM
)";

std::string bash_words(const std::vector<std::string>& words) {
  return fmt::format("({})", fmt::join(words, " "));
}

std::vector<std::string> bash_choices(const std::vector<OptionDescription>& positionals) {
  std::vector<std::string> choices;
  for (const OptionDescription& positional : positionals) {
    choices.insert(choices.end(), positional.choices.begin(), positional.choices.end());
  }
  return choices;
}

/// A case of the table of commands, and those of its own commands.
std::string bash_command_cases(const CommandDescription& command, const std::string& path) {
  std::vector<std::string> names;
  std::string inner_cases;
  for (const CommandDescription& inner : command.commands) {
    names.push_back(inner.name);
    inner_cases += bash_command_cases(inner, path + " " + inner.name);
  }
  std::vector<std::string> options;
  for (const OptionDescription& option : command.options) {
    options.insert(options.end(), option.names.begin(), option.names.end());
  }
  const bool has_files =
      std::any_of(command.positionals.begin(), command.positionals.end(), may_take_file);
  return fmt::format("    '{}')\n      commands={} words={} files={}\n      options={} ;;\n", path,
                     bash_words(names), bash_words(bash_choices(command.positionals)),
                     has_files ? "yes" : "", bash_words(options)) +
         inner_cases;
}

/// A case of the table of values for each option of the command, and those of its own commands.
std::string bash_value_cases(const CommandDescription& command, const std::string& path) {
  std::string cases;
  for (const OptionDescription& option : command.options) {
    if (option.value_name.empty()) {
      continue;
    }
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) {
      patterns.push_back(fmt::format("'{} {}'", path, name));
    }
    cases += fmt::format("    {}) words={} files={} ;;\n", fmt::join(patterns, " | "),
                         bash_words(option.choices), may_take_file(option) ? "yes" : "");
  }
  for (const CommandDescription& inner : command.commands) {
    cases += bash_value_cases(inner, path + " " + inner.name);
  }
  return cases;
}

/// A function that looks its argument up, and fails if it is none of the cases.
std::string bash_table(const std::string& name, const std::string& cases) {
  return fmt::format("\n{}() {{\n  case $1 in\n{}    *) return 1 ;;\n  esac\n}}\n", name, cases);
}

}  // namespace

std::string replaced_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string first_clause(const std::string& description) {
  std::size_t end = description.size();
  for (const char* detail : {" (", ": ", "; ", ". "}) {
    end = std::min(end, description.find(detail));
  }
  return description.substr(0, end);
}

std::string bash_completion(const CommandDescription& program) {
  const std::string& name = program.name;
  return fmt::format("# bash completion of {}\n\n# What can follow a command.", name) +
         bash_table("_" + name + "_command", bash_command_cases(program, name)) +
         "\n# What can follow an option that takes a value." +
         bash_table("_" + name + "_value", bash_value_cases(program, name)) +
         replaced_all(bash_function, "PROGRAM", name);
}

std::string fish_completion(const CommandDescription& program) {
  return replaced_all(fish_functions, "PROGRAM", program.name) +
         fish_lines(program.name, program, "");
}

std::string zsh_completion(const CommandDescription& program) {
  return fmt::format("#compdef {}\n", program.name) + zsh_functions(program, "_" + program.name) +
         replaced_all(zsh_end, "PROGRAM", program.name);
}

}  // namespace foveola
