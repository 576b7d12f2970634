// Lines of the experimenter's, read by a thread of its own.
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
  /// descriptor: standard input's, say; it stays open. One that is closed has no lines.
  explicit LineReader(int descriptor);

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
