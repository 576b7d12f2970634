// Loops over threads whose results do not depend on the number of threads, and the processors that
// this process may use.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace foveola {

/// Items in a block, at least 1; the last may have fewer.
struct BlockSizes {
  std::size_t smallest;
  std::size_t largest;
};

/// A fixed number of worker threads (oneTBB). Denormals are flushed to zero inside the loops, as
/// Embree asks of every thread that traces.
class Workers {
 public:
  /// threads: 0 takes every core that usable_cores() counts.
  explicit Workers(int threads = 0);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int threads() const { return threads_; }

  /// Calls body(begin, end) for the blocks of `block` items that partition [0, count), at the same
  /// time. They are begun from first to last. Returns when all are done; rethrows the first
  /// exception. Throws WorkStopped between blocks if the calling thread's work is stopped (see
  /// WorkScope).
  void for_each_block(std::size_t count, std::size_t block,
                      const std::function<void(std::size_t begin, std::size_t end)>& body) const;

  /// The same with blocks that become smaller towards the end, so that all threads end at about the
  /// same time: each has the part of what is left that two blocks for each thread would have
  /// (after Polychronopoulos and Kuck 1987, "Guided self-scheduling", with half their size).
  void for_each_shrinking_block(
      std::size_t count, const BlockSizes& sizes,
      const std::function<void(std::size_t begin, std::size_t end)>& body) const;

 private:
  void for_each_index(std::size_t count, const std::function<void(std::size_t)>& body) const;

  struct Arena;
  int threads_;
  std::unique_ptr<Arena> arena_;
};

/// The number of cores in the process's affinity, or as many as its cgroup's quota of time is
/// worth, rounded up, if that is fewer. At least 1.
int usable_cores();

/// The cores' worth of time that `cgroup` and those above it have, by their cpu.max (Linux,
/// Documentation/admin-guide/cgroup-v2.rst); empty without a limit. mount: of all cgroups.
std::optional<double> cgroup_cores(const std::filesystem::path& mount,
                                   const std::filesystem::path& cgroup);

}  // namespace foveola
