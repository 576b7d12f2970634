// Runs jobs in parallel and delivers their results in order.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

namespace foveola {

/// Calls work(i) for i in [0, count) on `jobs` threads, and take(i, result) on the calling thread
/// in the order of i, until `take` returns false or all are done. At most `ahead` jobs are begun
/// beyond the last taken result, which bounds the memory behind a slow job. Rethrows the first
/// exception of `work` (in order) or `take` once every thread has ended.
template <typename Result>
class OrderedJobs {
 public:
  using Work = std::function<Result(std::size_t index)>;
  using Take = std::function<bool(std::size_t index, Result result)>;

  OrderedJobs(std::size_t count, std::size_t ahead, Work work)
      : count_(count), ahead_(ahead), work_(std::move(work)) {}

  void run(int jobs, const Take& take) {
    std::vector<std::jthread> threads;
    // On any exit no new job begins and the threads are joined, in this order.
    const EndOnExit end{*this};
    for (int i = 0; i < jobs; ++i) {
      threads.emplace_back([this] { work_on(); });
    }
    for (std::size_t index = 0; index < count_; ++index) {
      Done done = wait_for(index);
      if (done.fault) {
        std::rethrow_exception(done.fault);
      }
      if (!take(index, std::move(*done.result))) {
        break;
      }
      took(index);
    }
    finish();
  }

 private:
  struct Done {
    std::optional<Result> result;
    std::exception_ptr fault;
  };
  struct EndOnExit {
    OrderedJobs& jobs;
    ~EndOnExit() { jobs.finish(); }
  };

  void work_on() {
    while (const std::optional<std::size_t> index = next()) {
      Done done;
      try {
        done.result = work_(*index);
      } catch (...) {
        done.fault = std::current_exception();
      }
      const std::lock_guard hold(mutex_);
      done_.emplace(*index, std::move(done));
      changed_.notify_all();
    }
  }

  /// Waits for room for one more job; nullopt if no more are to begin.
  std::optional<std::size_t> next() {
    std::unique_lock hold(mutex_);
    changed_.wait(hold,
                  [this] { return is_over_ || begun_ == count_ || begun_ < taken_ + ahead_; });
    return is_over_ || begun_ == count_ ? std::nullopt : std::optional(begun_++);
  }

  Done wait_for(std::size_t index) {
    std::unique_lock hold(mutex_);
    changed_.wait(hold, [&] { return done_.contains(index); });
    return std::move(done_.extract(index).mapped());
  }

  void took(std::size_t index) {
    const std::lock_guard hold(mutex_);
    taken_ = index + 1;
    changed_.notify_all();
  }

  void finish() {
    const std::lock_guard hold(mutex_);
    is_over_ = true;
    changed_.notify_all();
  }

  const std::size_t count_;
  const std::size_t ahead_;
  const Work work_;
  std::mutex mutex_;  ///< guards the members below
  std::condition_variable changed_;
  std::size_t begun_ = 0;
  std::size_t taken_ = 0;
  bool is_over_ = false;
  std::map<std::size_t, Done> done_;
};

}  // namespace foveola
