// Scripts by which shells complete a program's command line.
#pragma once

#include <string>

#include "renderer/command_line/command_description.h"

namespace foveola {

// Each script completes the names of commands, the options of the command that was typed, and
// values: the choices where the option or positional lists them, nothing where it takes a number,
// otherwise names of files. Names and choices must be without blanks, quotes and what shells
// expand.

/// For bash from 4.0 on, without the package bash-completion. Defines the functions _NAME,
/// _NAME_command and _NAME_value of the program NAME.
std::string bash_completion(const CommandDescription& program);

/// For zsh: to be read by `source`, or a file _NAME in a folder of $fpath. Defines a function
/// _NAME_COMMAND for each command.
std::string zsh_completion(const CommandDescription& program);

/// For fish from 3.0 on.
std::string fish_completion(const CommandDescription& program);

/// `text` with each `from` in it put as `to`.
std::string replaced_all(std::string text, const std::string& from, const std::string& to);

/// The beginning of a description up to where it goes into details, for a list in a terminal:
/// "Number of threads" of "Number of threads; 0: one for each core".
std::string first_clause(const std::string& description);

}  // namespace foveola
