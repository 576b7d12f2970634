// Completion of a program's command line in shells. The scripts ask the program itself, by
// `PROGRAM __complete WORD...`, so that they never differ from it.
#pragma once

#include <string>
#include <vector>

#include "renderer/command_line/command_description.h"

namespace foveola {

/// The command that the scripts give to the program, before the words typed so far.
inline constexpr const char* complete_command = "__complete";

/// What may stand in place of the last of `words`: a line for each, with a tab and its description
/// where there is one, and a line "/" if names of files may stand there, too. Completes commands,
/// the options of the command that was typed, and values: those that the option or positional
/// lists, none where it takes a number, otherwise names of files. words: those behind the
/// program's name, of which --option=value is one or, as bash has it, three; at least one.
std::string completions(const CommandDescription& program, std::vector<std::string> words);

/// The script for a shell: "bash" (from 4.0 on, without the package bash-completion), "zsh" (to be
/// read by `source`, or a file _NAME in a folder of $fpath) or "fish" (from 3.0 on).
std::string completion_script(const std::string& shell, const std::string& program);

/// The beginning of a description up to where it goes into details, for a list in a terminal:
/// "Number of threads" of "Number of threads; 0: one for each core".
std::string first_clause(const std::string& description);

}  // namespace foveola
