// This program's own file, installation and memory, and running other programs to their end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace foveola {

/// Where the running program's file lies; empty if the system does not say.
std::filesystem::path own_program();

/// Where Foveola was installed, as `cmake --install` means by its prefix; empty if this program, or
/// the library that this code is in, was not told of an installation when it was linked. It is two
/// steps above lib/foveola (or as many as the system's folder of libraries has), where the dynamic
/// linker looks for the modules, so that programs of others find it too.
std::optional<std::filesystem::path> installation_prefix();

/// What becomes of a program that we run when the user presses Ctrl-C, which reaches both.
enum class OnInterrupt : std::uint8_t {
  as_here,  ///< the same as of this program: where a thread waits for the signal, both go on
  ends      ///< it ends, unless it says otherwise itself
};

struct Command {
  std::vector<std::string>
      words;            ///< the program, sought on PATH unless it is a path; its arguments
  std::string input{};  ///< on its standard input
  OnInterrupt on_interrupt = OnInterrupt::as_here;
  std::stop_token stop{};  ///< sends it SIGTERM
};

struct ProgramEnd {
  int status = 0;  ///< what wait() returned; 0: it succeeded
  std::string output;
  std::string errors;
};

/// Runs the program to its end, with what it prints kept in memory. Throws std::system_error if it
/// cannot be started.
ProgramEnd run_to_end(const Command& command);

/// Names a status other than 0: "exit status 2", or "signal 9 (Killed)".
std::string failure_named(int status);

/// From now on freed memory stays with the program, to be used again, where the C library can be
/// told so: for programs that load large files again and again, to which fresh pages cost more than
/// reading does. To be called before there are other threads.
void keep_freed_memory();

}  // namespace foveola
