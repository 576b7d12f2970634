// Runs programs as a user would and keeps what they said.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace foveola::test {

struct ProgramResult {
  int exit_code = -1;  ///< 128 + the signal's number if one ended it
  std::string output;
  std::string errors;
};

using Environment = std::vector<std::pair<std::string, std::string>>;

/// Runs `command` (program and arguments) to its end, with `environment` set on top of this
/// process's own, and no standard input.
ProgramResult run_program(const std::vector<std::string>& command,
                          const Environment& environment = {});

/// The built program with `arguments`.
ProgramResult run_foveola(std::vector<std::string> arguments, const Environment& environment = {});

/// A folder of its own for each test, removed afterwards.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }
  /// Names of everything in it, sorted.
  std::vector<std::string> entries() const;

 private:
  std::filesystem::path path_;
};

/// A small closed room with a lamp, as a .gltf with its buffer inside.
std::string room_gltf();

}  // namespace foveola::test
