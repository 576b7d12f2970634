// The experimenter's console: typed lines beside the session, and what they ask for.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace foveola::study {

enum class ConsoleAction {
  state,
  next,
  note,
  pause,
  resume,
  retime,
  exclude,
  withdraw,
  quit,
  help,
};

struct ConsoleCommand {
  ConsoleAction action = ConsoleAction::help;
  std::string text;  ///< a note's words, or the reason of an exclusion
};

/// What a line asks for. Empty if it asks for nothing that is known, or lacks the text it needs.
std::optional<ConsoleCommand> parse_console_line(std::string_view line);

/// A line for each command.
std::string console_help();

/// Reads lines from a file descriptor in a thread of its own, until the other end closes it.
class ConsoleLines {
 public:
  /// descriptor: standard input's, say; it stays open. One that is closed has no lines.
  explicit ConsoleLines(int descriptor);

  /// All whole lines since the last call, in order.
  std::vector<std::string> take();

 private:
  void read(int descriptor, const std::stop_token& stop);
  void keep(std::string_view bytes);

  std::mutex mutex_;
  std::vector<std::string> lines_;
  std::string unfinished_;  ///< the reading thread's
  std::jthread thread_;     ///< last: it ends before the rest does
};

}  // namespace foveola::study
