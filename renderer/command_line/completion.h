// Shell completion of a program's command line. The scripts call the program itself, by `PROGRAM
// __complete WORD...`, so that they never differ from it.
#pragma once

#include <string>
#include <vector>

#include "renderer/command_line/command_description.h"

namespace foveola {

/// The command of the scripts, before the words typed so far.
inline constexpr const char* complete_command = "__complete";

/// The completions of the last of `words`: one per line, with a tab and a description if there is
/// one, and a line "/" if file names are possible, too. Completes commands, the typed command's
/// options, and values: the listed ones of the option or positional, none for a number, otherwise
/// file names. words: without the program's name, at least one; --option=value is one word or, as
/// in bash, three.
std::string completions(const CommandDescription& program, std::vector<std::string> words);

/// The script for a shell: "bash" (from 4.0 on, without the package bash-completion), "zsh" (to be
/// read by `source`, or a file _NAME in a folder of $fpath) or "fish" (from 3.0 on).
std::string completion_script(const std::string& shell, const std::string& program);

/// The beginning of a description, before its details, for a list in a terminal: "Number of
/// threads" of "Number of threads; 0: one for each core".
std::string first_clause(const std::string& description);

}  // namespace foveola
