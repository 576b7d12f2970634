#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/command_line/completion.h"
#include "renderer/command_line/shell_text.h"

namespace foveola {
namespace {

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

}  // namespace

std::string fish_completion(const CommandDescription& program) {
  return replaced_all(fish_functions, "PROGRAM", program.name) +
         fish_lines(program.name, program, "");
}

}  // namespace foveola
