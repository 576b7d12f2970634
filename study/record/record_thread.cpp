#include "study/record/record_thread.h"

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace foveola::study {

struct RecordThread::Implementation {
  using Task = std::packaged_task<void()>;

  explicit Implementation(StudyStore& store_in) : store(store_in), thread([this] { work(); }) {}

  ~Implementation() {
    {
      const std::lock_guard hold(mutex);
      is_closing = true;
    }
    something_new.notify_one();
    thread.join();
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  /// write: commits to the store.
  template <typename Write>
  std::future<void> submit(Write write) {
    Task task([this, write = std::move(write)] { write_unless_failed(write); });
    std::future<void> done = task.get_future();
    {
      const std::lock_guard hold(mutex);
      tasks.push_back(std::move(task));
    }
    something_new.notify_one();
    return done;
  }

  template <typename Write>
  void write_unless_failed(const Write& write) {
    if (failure) {
      std::rethrow_exception(failure);
    }
    try {
      write(store);
    } catch (...) {
      failure = std::current_exception();
      throw;
    }
  }

  void work() {
    while (std::optional<Task> task = next_task()) {
      (*task)();
    }
  }

  /// Waits for one; empty once all are done and no more will come.
  std::optional<Task> next_task() {
    std::unique_lock hold(mutex);
    something_new.wait(hold, [this] { return is_closing || !tasks.empty(); });
    if (tasks.empty()) {
      return std::nullopt;
    }
    Task task = std::move(tasks.front());
    tasks.pop_front();
    return task;
  }

  StudyStore& store;
  std::exception_ptr failure;  ///< the thread's own
  std::mutex mutex;            ///< guards what follows
  std::condition_variable something_new;
  std::deque<Task> tasks;
  bool is_closing = false;
  std::thread thread;
};

RecordThread::RecordThread(StudyStore& store)
    : implementation_(std::make_unique<Implementation>(store)) {}

RecordThread::~RecordThread() = default;

std::future<void> RecordThread::event(std::int64_t session, Nanoseconds time, Event event,
                                      SessionState before, SessionState after) {
  return implementation_->submit([session, time, event = std::move(event),
                                  before = std::move(before),
                                  after = std::move(after)](StudyStore& store) {
    store.record_event(session, time, event, before, after);
  });
}

std::future<void> RecordThread::frames(std::int64_t session, std::size_t trial, int attempt,
                                       std::uint64_t first_frame, std::vector<FrameRow> frames) {
  return implementation_->submit(
      [session, trial, attempt, first_frame, frames = std::move(frames)](StudyStore& store) {
        store.record_frames(session, trial, attempt, first_frame, frames);
      });
}

std::future<void> RecordThread::gaze(std::int64_t session, std::size_t trial, int attempt,
                                     std::uint64_t first_sample, std::vector<GazeSample> samples) {
  return implementation_->submit(
      [session, trial, attempt, first_sample, samples = std::move(samples)](StudyStore& store) {
        store.record_gaze(session, trial, attempt, first_sample, samples);
      });
}

std::future<void> RecordThread::film_hash(std::int64_t session, std::size_t trial, int attempt,
                                          FilmHash hash) {
  return implementation_->submit(
      [session, trial, attempt, hash = std::move(hash)](StudyStore& store) {
        store.record_film_hash(session, trial, attempt, hash);
      });
}

}  // namespace foveola::study
