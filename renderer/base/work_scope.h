// Stops long work, and shows its progress, without a parameter in every function that it calls.
#pragma once

#include <functional>
#include <stop_token>

namespace foveola {

/// Thrown in work that was stopped. Not a std::exception: no handler of errors may take it for one.
struct WorkStopped {};

/// Lets the work of its thread, while it lives, be stopped. Loops of Workers that this work begins
/// belong to it. Work outside of any scope is never stopped.
class WorkScope {
 public:
  /// step: what is done now. fraction_done: of this step, in [0, 1].
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

  /// Lets this thread work for `scope`, which may be null, while it lives.
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

/// Whether this thread's work was stopped.
bool is_work_stopped();

/// Throws WorkStopped if this thread's work was stopped.
void throw_if_work_stopped();

}  // namespace foveola
