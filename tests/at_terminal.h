// A process at a terminal of its own, whose keys and eyes are the test's.
#pragma once

#include <functional>
#include <string>

#include <sys/types.h>

namespace foveola::test {

class AtTerminal {
 public:
  /// kind: as TERM names it. body: what the process does; returns its exit code.
  AtTerminal(const char* kind, const std::function<int()>& body);
  /// Kills the process if it still runs.
  ~AtTerminal();
  AtTerminal(const AtTerminal&) = delete;
  AtTerminal& operator=(const AtTerminal&) = delete;

  void type(const std::string& keys) const;

  /// Waits until `words` were written or painted. What is painted over something else comes in
  /// pieces, and as a whole only once the size changes: so it changes, to and fro. Throws
  /// std::runtime_error, with all that was seen, if they never are.
  void wait_for(const std::string& words);

  /// All that was read so far.
  const std::string& seen() const { return seen_; }

  /// All that was written and painted until the process has ended.
  std::string all_seen();

  /// Waits for the process's end, and reads nothing meanwhile. Returns what waitpid says of it.
  int wait_without_reading();
  /// The same once the terminal was closed, as the window manager's cross does.
  int close_and_wait();

 private:
  /// What there is. Returns false once nobody is at the other end.
  bool read();

  int terminal_ = -1;
  pid_t process_ = -1;
  std::string seen_;
};

}  // namespace foveola::test
