// A progress line with the time left, for work that takes longer than a second or two.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
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

/// A progress line for each step of work, as soon as the work takes longer than a second. Its
/// functions may be called from any thread.
class StepProgress {
 public:
  /// label: stands before the name of the step; may be empty.
  explicit StepProgress(std::string label = {});

  /// fraction_done: of this step, in [0, 1].
  void update(const std::string& step, double fraction_done);

 private:
  std::string label_;
  std::chrono::steady_clock::time_point start_;
  std::mutex mutex_;  ///< guards what follows
  std::string step_;
  std::optional<Progress> line_;
};

/// "850 ms", "12 s", "3 m 05 s" or "2 h 10 m".
std::string human_duration(double duration_s);

}  // namespace foveola
