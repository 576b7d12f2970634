// This program's file, installation and memory; runs other programs to their end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace foveola {

/// Path of the running program; empty if the system does not say.
std::filesystem::path own_program();

/// The installation's prefix, as in `cmake --install`. nullopt if this program or library was not
/// linked for an installation. The prefix lies two steps above lib/foveola (or as many as the
/// system's library folder has), where the dynamic linker finds the modules. Programs of others
/// find it too.
std::optional<std::filesystem::path> installation_prefix();

/// A child program's reaction to Ctrl-C, which reaches both programs.
enum class OnInterrupt : std::uint8_t {
  as_here,  ///< as this program: if a thread waits for the signal, both continue
  ends      ///< the child ends, unless it handles the signal itself
};

struct Command {
  std::vector<std::string>
      words;            ///< the program, sought on PATH unless it is a path; its arguments
  std::string input{};  ///< on its standard input
  OnInterrupt on_interrupt = OnInterrupt::as_here;
  std::stop_token stop{};  ///< sends it SIGTERM
};

struct ProgramEnd {
  int status = 0;  ///< the status from wait(); 0: success
  std::string output;
  std::string errors;
};

/// Runs the program to its end and returns its output. Throws std::system_error if it cannot start.
ProgramEnd run_to_end(const Command& command);

/// Names a status other than 0: "exit status 2", or "signal 9 (Killed)".
std::string failure_named(int status);

/// Keeps freed memory in the process for reuse, if the C library allows it. For programs that load
/// large files repeatedly, for which fresh pages cost more than reading. To be called before other
/// threads start.
void keep_freed_memory();

}  // namespace foveola
