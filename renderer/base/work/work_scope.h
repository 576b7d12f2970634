// Long work that can be stopped and reports its progress, without parameters in every function.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace foveola {

/// Thrown in stopped work. Not a std::exception, so that no error handler catches it.
struct WorkStopped {};

/// Makes the work of its thread stoppable while it lives, including loops of Workers that this work
/// begins. Work outside any scope is never stopped.
class WorkScope {
 public:
  /// step: the name of the current step. fraction_done: of this step, in [0, 1].
  using Report = std::function<void(const char* step, double fraction_done)>;

  /// report: called from any thread of the work; may be empty.
  explicit WorkScope(std::stop_token stop, Report report = {});
  ~WorkScope();
  WorkScope(const WorkScope&) = delete;
  WorkScope& operator=(const WorkScope&) = delete;

  bool is_stopped() const { return stop_.stop_requested(); }
  void report(const char* step, double fraction_done) const;

  /// The innermost scope of this thread, or null.
  static const WorkScope* current();

  /// Lets this thread work for `scope` while it lives; may be null.
  class Member {
   public:
    explicit Member(const WorkScope* scope);
    ~Member();
    Member(const Member&) = delete;
    Member& operator=(const Member&) = delete;

   private:
    const WorkScope* before_;
  };

 private:
  std::stop_token stop_;
  Report report_;
  Member member_;
};

/// Whether this thread's work has been stopped.
bool is_work_stopped();

/// Throws WorkStopped if this thread's work has been stopped.
void throw_if_work_stopped();

/// Writes "LABEL  42 %  1 m 10 s left" over one line of standard error, at most ten times a second,
/// cut to its width. If that is not a terminal that obeys escapes, a plain line at every tenth of
/// the work and after five minutes without one. The line ends with the object.
class Progress {
 public:
  explicit Progress(std::string label);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// fraction_done in [0, 1]; never decreases. detail: shown behind the time left.
  void update(double fraction_done, const std::string& detail = {});

 private:
  std::string label_;
  bool terminal_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_shown_;
  int last_tenth_ = 0;
};

/// Progress lines for steps of work that takes over a second. May be called from any thread.
class StepProgress {
 public:
  /// label: stands before the name of the step; may be empty.
  explicit StepProgress(std::string label = {});

  /// fraction_done: of this step, in [0, 1].
  void update(const std::string& step, double fraction_done);

 private:
  std::string label_;
  std::chrono::steady_clock::time_point start_;
  std::mutex mutex_;  ///< guards the members below
  std::string step_;
  std::optional<Progress> line_;
};

/// "850 ms", "12 s", "3 m 05 s" or "2 h 10 m".
std::string human_duration(double duration_s);

/// Exit code of a program stopped by a signal, as a shell gives for SIGINT.
inline constexpr int stopped_exit_code = 130;

/// Prints on standard error that a load was stopped.
void print_load_stopped();

/// Returns the result of `load`. Shows its reported steps on standard error. Throws WorkStopped
/// soon after `stop` is requested.
template <typename Load>
auto load_watched(const std::stop_token& stop, const Load& load) {
  StepProgress progress("loading: ");
  const WorkScope scope(
      stop, [&](const char* step, double fraction_done) { progress.update(step, fraction_done); });
  return load();
}

/// Ends the program with print_load_stopped and stopped_exit_code if it still lives 0.2 s after
/// `stop` was requested, since libraries' parsers and decoders cannot be stopped. For commands that
/// have written nothing yet.
class StuckLoadExit {
 public:
  explicit StuckLoadExit(const std::stop_token& stop);

 private:
  std::jthread watcher_;  ///< stopped and joined by its destructor
};

/// load_watched of a command that has written nothing yet: see StuckLoadExit.
template <typename Load>
auto load_or_exit(const std::stop_token& stop, const Load& load) {
  const StuckLoadExit exit(stop);
  return load_watched(stop, load);
}

}  // namespace foveola
