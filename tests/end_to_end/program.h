// Runs programs as a user would and keeps what they said.
#pragma once

#include <source_location>
#include <string>
#include <utility>
#include <vector>

#include "tests/temporary_folder.h"

namespace foveola::test {

struct ProgramResult {
  int exit_code = -1;  ///< 128 + the signal's number if one ended it
  std::string output;
  std::string errors;
};

using Environment = std::vector<std::pair<std::string, std::string>>;

/// Makes this process the program of `command`, found as a shell would, with `environment` set on
/// top of its own; 127 is its exit code if that cannot be. For a child of a fork.
[[noreturn]] void become(const std::vector<std::string>& command, const Environment& environment);

/// Runs `command` (program and arguments) to its end, with `environment` set on top of this
/// process's own, and no standard input.
ProgramResult run_program(const std::vector<std::string>& command,
                          const Environment& environment = {});

/// The built program with `arguments`.
ProgramResult run_foveola(std::vector<std::string> arguments, const Environment& environment = {});

/// `words`, and `more` behind them.
std::vector<std::string> joined(std::vector<std::string> words,
                                const std::vector<std::string>& more);

/// `result`; the test fails where it asked for it unless the program did as it was told.
ProgramResult succeeded(ProgramResult result,
                        std::source_location place = std::source_location::current());

/// Fails the test unless this exit code came with a single line of error, which holds `says`, and
/// nothing else was printed.
void expect_one_line(const ProgramResult& result, int exit_code, const std::string& says);

/// `text` with `to` where it first has `from`; throws std::out_of_range where it has not.
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// A small closed room with a lamp, as a .gltf with its buffer inside.
std::string room_gltf();

}  // namespace foveola::test
