#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/command_line/completion.h"
#include "renderer/command_line/shell_text.h"

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

}  // namespace

std::string zsh_completion(const CommandDescription& program) {
  return fmt::format("#compdef {}\n", program.name) + zsh_functions(program, "_" + program.name) +
         replaced_all(zsh_end, "PROGRAM", program.name);
}

}  // namespace foveola
