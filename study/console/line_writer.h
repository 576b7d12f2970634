// Lines for the experimenter, written by a thread of its own: a terminal that is stopped, closed or
// far away must not hold up a participant's frames.
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
  /// How long its end waits for a reader who takes nothing.
  static constexpr std::chrono::milliseconds patience{1000};

  /// descriptor: standard output's, say; it stays open. Of one that nobody reads any more, what is
  /// written is lost.
  explicit LineWriter(int descriptor);
  /// Waits until all is written, or nobody takes it.
  ~LineWriter();
  LineWriter(const LineWriter&) = delete;
  LineWriter& operator=(const LineWriter&) = delete;

  /// Does not wait. Each line of `text` is escaped() and ended.
  void write(const std::string& text);

 private:
  void run();

  int descriptor_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string text_;  ///< what was not written yet, after the first `written_` characters
  std::size_t written_ = 0;
  bool is_closing_ = false;
  std::thread thread_;
};

/// A terminal that has room for any has room for so many bytes; a pipe for more.
inline constexpr std::size_t max_taken_at_once = 256;

/// Writes the beginning of `text` once `descriptor` takes any. Returns how many bytes were taken: 0
/// if none were within `longest`, all if none ever will be again.
std::size_t write_taken(int descriptor, std::string_view text, std::chrono::milliseconds longest);

}  // namespace foveola::study
