#include "renderer/base/work/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <fstream>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <sched.h>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "renderer/base/work/work_scope.h"

#if defined(__SSE2__)
#include <pmmintrin.h>
#endif

#if defined(__SANITIZE_THREAD__)
#define FOVEOLA_THREAD_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define FOVEOLA_THREAD_SANITIZER 1
#endif
#endif

namespace fs = std::filesystem;

namespace foveola {
namespace {

/// Sets flush-to-zero and denormals-are-zero for its lifetime, on its own thread.
class FlushDenormals {
 public:
#if defined(__SSE2__)
  FlushDenormals() : saved_(_mm_getcsr()) {
    _mm_setcsr(saved_ | _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON);
  }
  ~FlushDenormals() { _mm_setcsr(saved_); }
#else
  FlushDenormals() = default;
  ~FlushDenormals() = default;
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

#if defined(__SSE2__)
 private:
  unsigned saved_;
#endif
};

/// Calls body(0) to body(count - 1) in this order: each thread takes the first that has not begun.
/// Threads end together if the last bodies are short, and neighbours share cached data.
class InOrder {
 public:
  InOrder(std::size_t count, const std::function<void(std::size_t)>& body)
      : count_(count), body_(body) {}

  void work() {
    for (std::size_t i = next_++; i < count_; i = next_++) {
      body_(i);
    }
  }

 private:
  std::size_t count_;
  const std::function<void(std::size_t)>& body_;
  std::atomic<std::size_t> next_ = 0;
};

#if defined(FOVEOLA_THREAD_SANITIZER)
/// The thread sanitizer does not see the ordering of tasks in TBB's library, and would report races
/// in every loop. It sees all of this one.
void on_each_thread(tbb::task_arena& arena, const std::function<void()>& work) {
  std::exception_ptr first_error;
  std::mutex error_mutex;
  const auto try_to_work = [&] {
    try {
      work();
    } catch (...) {
      const std::scoped_lock lock(error_mutex);
      first_error = first_error ? first_error : std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int thread = 0; thread < arena.max_concurrency(); ++thread) {
      threads.emplace_back(try_to_work);
    }
  }
  if (first_error) {
    std::rethrow_exception(first_error);
  }
}
#else
void on_each_thread(tbb::task_arena& arena, const std::function<void()>& work) {
  arena.execute([&] {
    tbb::parallel_for(0, arena.max_concurrency(), [&](int) { work(); }, tbb::simple_partitioner());
  });
}
#endif

/// The path of this process's cgroup of a controller; "" for version 2, which has none (Linux,
/// `man 7 cgroups`: lines ID:CONTROLLERS:/PATH). Empty if there is none.
fs::path own_cgroup(const std::string& controller) {
  std::ifstream cgroups("/proc/self/cgroup");
  for (std::string line; std::getline(cgroups, line);) {
    const std::size_t begin = line.find(':') + 1;
    const std::size_t end = std::min(line.find(":/", begin), line.size());
    const std::string controllers = "," + line.substr(begin, end - begin) + ",";
    if (controllers.find("," + controller + ",") != std::string::npos) {
      return line.substr(std::min(end + 2, line.size()));
    }
  }
  return {};
}

int cores_of_affinity() {
  cpu_set_t cores;
  return ::sched_getaffinity(0, sizeof cores, &cores) == 0
             ? CPU_COUNT(&cores)
             : static_cast<int>(std::thread::hardware_concurrency());
}

}  // namespace

/// The control lifts TBB's own limit, so that four threads on two cores are four threads.
struct Workers::Arena {
  explicit Arena(int threads)
      : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
        arena(threads) {}
  tbb::global_control control;
  tbb::task_arena arena;
};

Workers::Workers(int threads)
    : threads_(threads > 0 ? threads : usable_cores()), arena_(std::make_unique<Arena>(threads_)) {}

Workers::~Workers() = default;

void Workers::for_each_block(
    std::size_t count, std::size_t block,
    const std::function<void(std::size_t begin, std::size_t end)>& body) const {
  for_each_index((count + block - 1) / block,
                 [&](std::size_t i) { body(i * block, std::min(count, (i + 1) * block)); });
}

void Workers::for_each_shrinking_block(
    std::size_t count, const BlockSizes& sizes,
    const std::function<void(std::size_t begin, std::size_t end)>& body) const {
  const std::size_t parts = 2 * static_cast<std::size_t>(threads_);
  std::vector<std::size_t> begins = {0};
  for (std::size_t left = count; left > 0; left = count - begins.back()) {
    const std::size_t size = std::clamp(left / parts, sizes.smallest, sizes.largest);
    begins.push_back(begins.back() + std::min(size, left));
  }
  for_each_index(begins.size() - 1, [&](std::size_t i) { body(begins[i], begins[i + 1]); });
}

void Workers::for_each_index(std::size_t count,
                             const std::function<void(std::size_t)>& body) const {
  const WorkScope* const scope = WorkScope::current();
  const auto flushed = [&](std::size_t i) {
    const WorkScope::Member member(scope);
    throw_if_work_stopped();
    const FlushDenormals flush;
    body(i);
  };
  const std::function<void(std::size_t)> each = flushed;
  InOrder indices(count, each);
  on_each_thread(arena_->arena, [&] { indices.work(); });
}

std::optional<double> cgroup_cores(const fs::path& mount, const fs::path& cgroup) {
  std::optional<double> fewest;
  fs::path folder = mount;
  const auto look = [&] {
    // Without a limit, the quota is "max" or -1.
    double quota_us = 0.0;
    double period_us = 0.0;
    const bool is_read = std::ifstream(folder / "cpu.max") >> quota_us >> period_us ||
                         (std::ifstream(folder / "cpu.cfs_quota_us") >> quota_us &&
                          std::ifstream(folder / "cpu.cfs_period_us") >> period_us);
    if (is_read && quota_us > 0.0 && period_us > 0.0) {
      fewest = std::min(fewest.value_or(HUGE_VAL), quota_us / period_us);
    }
  };
  look();
  for (const fs::path& name : cgroup) {
    folder /= name;
    look();
  }
  return fewest;
}

int usable_cores() {
  const int cores = cores_of_affinity();
  double quota = cores;
  for (const std::string controller : {"", "cpu"}) {
    const fs::path mount = fs::path("/sys/fs/cgroup") / controller;
    quota = std::min(quota, cgroup_cores(mount, own_cgroup(controller)).value_or(cores));
  }
  return std::max(1, static_cast<int>(std::ceil(quota)));
}

}  // namespace foveola
