// Writes lines for the experimenter in a thread of its own, so that a stopped, closed or remote
// terminal does not delay a participant's frames.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace foveola::study {

class LineWriter {
 public:
  /// Maximum time that the destructor waits for a reader who takes nothing.
  static constexpr std::chrono::milliseconds patience{1000};

  /// descriptor: such as standard output; it stays open. If its reader is gone, the text is lost.
  explicit LineWriter(int descriptor);
  /// Waits until everything is written, or its reader takes nothing more.
  ~LineWriter();
  LineWriter(const LineWriter&) = delete;
  LineWriter& operator=(const LineWriter&) = delete;

  /// Queues text without waiting. Each line of `text` is escaped() and ended.
  void write(const std::string& text);

 private:
  void run();

  int descriptor_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string text_;  ///< the unwritten text follows the first `written_` characters
  std::size_t written_ = 0;
  bool is_closing_ = false;
  std::thread thread_;
};

/// Number of bytes that fit whenever a terminal has room for any; a pipe has room for more.
inline constexpr std::size_t max_taken_at_once = 256;

/// Writes the beginning of `text` once `descriptor` accepts data. Returns the number of bytes
/// written: 0 after `longest`, text.size() if the reader is gone.
std::size_t write_taken(int descriptor, std::string_view text, std::chrono::milliseconds longest);

}  // namespace foveola::study
