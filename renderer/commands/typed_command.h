// What a user typed that the command line does not understand, in words.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace foveola {

/// Has help state the default of every option of `app` and of its commands whose description does
/// not. Makes options that take numbers say so of what is none ("'5s' is no number"), and those
/// that take whole numbers accept them as 1e6 too and refuse what 64 bits do not hold. To be called
/// when all options are there.
void complete_options(CLI::App& app);

/// The first of the words that stands where a command must, and is none. Throws UsageError that
/// asks for the one that was meant. words: as typed, without the program's name.
void reject_unknown_commands(const CLI::App& app, const std::vector<std::string>& words);

/// The command as far as it was understood: "foveola study simulate". app: after parsing.
std::string typed_command(const CLI::App& app);

/// What was wrong with the command line, and what to do, on one line. app: after parsing, which
/// threw `error`.
std::string fault_text(const CLI::App& app, const CLI::ParseError& error);

}  // namespace foveola
