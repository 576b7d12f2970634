// Parallel loops whose results do not depend on the number of threads, and the usable cores.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace foveola {

/// Minimum and maximum number of items in a block, at least 1; the last block may have fewer.
struct BlockSizes {
  std::size_t smallest;
  std::size_t largest;
};

/// A fixed number of worker threads (oneTBB). Denormals are flushed to zero inside the loops, as
/// Embree requires of tracing threads.
class Workers {
 public:
  /// threads: 0 takes every core that usable_cores() counts.
  explicit Workers(int threads = 0);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int threads() const { return threads_; }

  /// Calls body(begin, end) in parallel for blocks of `block` items that partition [0, count),
  /// begun in order. Returns when all are done; rethrows the first exception. Throws WorkStopped
  /// between blocks if the calling thread's work is stopped (see WorkScope).
  void for_each_block(std::size_t count, std::size_t block,
                      const std::function<void(std::size_t begin, std::size_t end)>& body) const;

  /// The same with blocks that shrink towards the end, so that all threads end at about the same
  /// time. Each block holds the remaining items divided by twice the number of threads (after
  /// Polychronopoulos and Kuck 1987, "Guided self-scheduling", with half their size).
  void for_each_shrinking_block(
      std::size_t count, const BlockSizes& sizes,
      const std::function<void(std::size_t begin, std::size_t end)>& body) const;

 private:
  void for_each_index(std::size_t count, const std::function<void(std::size_t)>& body) const;

  struct Arena;
  int threads_;
  std::unique_ptr<Arena> arena_;
};

/// The smaller of the process's CPU affinity and its cgroup's CPU quota, rounded up. At least 1.
int usable_cores();

/// The CPU quota of `cgroup` and its parents in cores; nullopt without a limit. mount: of all
/// cgroups. From cpu.max (Linux, Documentation/admin-guide/cgroup-v2.rst) or, in version 1, from
/// cpu.cfs_quota_us and cpu.cfs_period_us (Documentation/scheduler/sched-bwc.rst).
std::optional<double> cgroup_cores(const std::filesystem::path& mount,
                                   const std::filesystem::path& cgroup);

}  // namespace foveola
