#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/command_line/completion.h"
#include "renderer/command_line/shell_text.h"

namespace foveola {
namespace {

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

std::string bash_completion(const CommandDescription& program) {
  const std::string& name = program.name;
  return fmt::format("# bash completion of {}\n\n# What can follow a command.", name) +
         bash_table("_" + name + "_command", bash_command_cases(program, name)) +
         "\n# What can follow an option that takes a value." +
         bash_table("_" + name + "_value", bash_value_cases(program, name)) +
         replaced_all(bash_function, "PROGRAM", name);
}

}  // namespace foveola
