// Reads the experimenter's lines in a thread of its own.
#pragma once

#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace foveola::study {

/// Reads lines from a file descriptor until the other end closes it.
class LineReader {
 public:
  /// descriptor: such as standard input; it stays open. A closed one has no lines.
  explicit LineReader(int descriptor);

  /// Returns all complete lines since the last call, in order.
  std::vector<std::string> take_lines();

 private:
  void read(int descriptor, const std::stop_token& stop);
  void keep(std::string_view bytes);

  std::mutex mutex_;
  std::vector<std::string> lines_;
  std::string unfinished_;  ///< used by the reading thread only
  std::jthread thread_;     ///< last: it ends before the other members do
};

}  // namespace foveola::study
