// A progress line with the time left, for work that takes longer than a second or two.
#pragma once

#include <chrono>
#include <string>

namespace foveola {

/// Writes "LABEL  42 %  1 m 10 s left" over one line of standard error, at most ten times a second,
/// and only when that is a terminal that obeys escapes, cut to its width; otherwise a plain line at
/// every tenth of the work, and when five minutes have gone by without one. The line is finished
/// when the object goes.
class Progress {
 public:
  explicit Progress(std::string label);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// fraction_done in [0, 1]; never goes back. detail is shown behind the time left.
  void update(double fraction_done, const std::string& detail = {});

 private:
  std::string label_;
  bool terminal_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_shown_;
  int last_tenth_ = 0;
};

/// "850 ms", "12 s", "3 m 05 s" or "2 h 10 m".
std::string human_duration(double duration_s);

}  // namespace foveola
