// A program that runs beside its test, which types into it and reads what it says meanwhile.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <sys/types.h>

#include "tests/end_to_end/program.h"

namespace foveola::test {

class RunningProgram {
 public:
  /// The built program with `arguments`. environment: on top of this process's own.
  explicit RunningProgram(std::vector<std::string> arguments, const Environment& environment = {});
  /// Kills it if it still runs.
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  /// Into its standard input.
  void type_line(const std::string& line) const;
  /// Waits until it has said `words` on its standard output or error after what was waited for
  /// before, and returns the line up to its end. Throws std::runtime_error, with all that was said,
  /// if it never does.
  std::string wait_for(const std::string& words);
  /// All that it has said so far.
  std::string said();
  void kill(int signal) const;
  pid_t process() const { return process_; }
  bool has_ended();
  /// Waits for its end, and until all that it said is read. Returns its exit code, or 128 + the
  /// signal's number.
  int wait_for_end();

 private:
  void read();

  pid_t process_ = -1;
  int input_ = -1;
  int output_ = -1;
  std::mutex mutex_;  ///< guards what was said
  std::string said_;
  std::size_t waited_for_ = 0;  ///< so much of it
  std::optional<int> status_;   ///< as waitpid reports it, once it has ended
  std::jthread reader_;
};

}  // namespace foveola::test
