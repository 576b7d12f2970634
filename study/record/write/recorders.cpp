#include "study/record/write/recorders.h"

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace foveola::study {

std::future<void> BufferedRecorder::record(SessionEntry entry) {
  entries_.push_back(std::move(entry));
  return already_recorded();
}

void BufferedRecorder::write(StudyStore& store, const SessionFacts& facts, const Plan& plan) const {
  store.record_together([&] {
    const std::int64_t session = store.begin_session(facts, plan);
    for (const SessionEntry& entry : entries_) {
      store.record(session, entry);
    }
  });
}

struct ThreadedRecorder::Implementation {
  using Task = std::packaged_task<void()>;

  Implementation(StudyStore& store_in, std::int64_t session_in)
      : store(store_in), session(session_in), thread([this] { work(); }) {}

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

  std::future<void> submit(SessionEntry entry) {
    Task task([this, entry = std::move(entry)] { write_unless_failed(entry); });
    std::future<void> done = task.get_future();
    {
      const std::lock_guard hold(mutex);
      tasks.push_back(std::move(task));
    }
    something_new.notify_one();
    return done;
  }

  void write_unless_failed(const SessionEntry& entry) {
    if (failure) {
      std::rethrow_exception(failure);
    }
    try {
      store.record(session, entry);
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
  std::int64_t session;
  std::exception_ptr failure;  ///< the thread's own
  std::mutex mutex;            ///< guards what follows
  std::condition_variable something_new;
  std::deque<Task> tasks;
  bool is_closing = false;
  std::thread thread;
};

ThreadedRecorder::ThreadedRecorder(StudyStore& store, std::int64_t session)
    : implementation_(std::make_unique<Implementation>(store, session)) {}

ThreadedRecorder::~ThreadedRecorder() = default;

std::future<void> ThreadedRecorder::record(SessionEntry entry) {
  return implementation_->submit(std::move(entry));
}

}  // namespace foveola::study
