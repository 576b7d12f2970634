// Loops over threads whose results do not depend on the number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace foveola {

/// A fixed number of worker threads (oneTBB). Denormals are flushed to zero inside the loops, as
/// Embree asks of every thread that traces.
class Workers {
 public:
  /// threads: 0 takes every core of the machine.
  explicit Workers(int threads = 0);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int threads() const { return threads_; }

  /// Calls body(begin, end) for the blocks of `block` items that partition [0, count), in any
  /// order, at the same time. Returns when all are done; rethrows the first exception.
  void for_each_block(std::size_t count, std::size_t block,
                      const std::function<void(std::size_t begin, std::size_t end)>& body) const;

 private:
  struct Arena;
  int threads_;
  std::unique_ptr<Arena> arena_;
};

}  // namespace foveola
