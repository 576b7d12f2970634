// Explains errors of a typed command line in words.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace foveola {

/// Completes the options of `app` and of its commands. Help states the default of each whose
/// description does not. Options of numbers report other values ("'5s' is not a number"), and
/// options of whole numbers accept notations like 1e6 and refuse values beyond 64 bits. To be
/// called after all options were added.
void complete_options(CLI::App& app);

/// Throws UsageError for the first word at a command's place that is not a command, with the
/// similar one. words: as typed, without the program's name.
void reject_unknown_commands(const CLI::App& app, const std::vector<std::string>& words);

/// The command as far as it was parsed: "foveola study simulate". app: after parsing.
std::string typed_command(const CLI::App& app);

/// The fault of the command line and its remedy, on one line. app: after parsing, which threw
/// `error`.
std::string fault_text(const CLI::App& app, const CLI::ParseError& error);

}  // namespace foveola
