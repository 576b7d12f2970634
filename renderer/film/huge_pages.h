// Memory of zeros, ready before it is needed.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include <sys/mman.h>

namespace foveola {

inline constexpr std::size_t huge_page = std::size_t{2} << 20;  ///< bytes

struct UnmapHugePage {
  void operator()(std::byte* memory) const { ::munmap(memory, huge_page); }
};
using HugePage = std::unique_ptr<std::byte[], UnmapHugePage>;

/// Hands out zeros in pieces that the system may give as a whole: where samples fall far apart,
/// finding pages and filling them one by one takes longer than the samples. Even as a whole each
/// takes a tenth of a millisecond, and several where a virtual machine gets the memory from its
/// host only then. So a thread can make the next ones ready.
class HugePages {
 public:
  /// Pages that are ready at a time: what is never taken costs no more than these.
  static constexpr std::size_t most_ready = 2;
  /// Who takes no more pages than these does without a thread.
  static constexpr std::size_t taken_without_thread = 3;

  /// From any thread. Throws std::bad_alloc.
  HugePage take();

  /// Returns at once, while a thread makes pages ready: the next calls of take give them out.
  void make_ready();

  /// Pages that are ready now.
  std::size_t ready() const;

 private:
  void make_pages(const std::stop_token& stop);

  mutable std::mutex mutex_;
  std::size_t taken_ = 0;
  std::vector<HugePage> ready_;
  std::condition_variable_any are_wanted_;
  std::jthread maker_;  ///< after what it uses, so that it ends before that
};

}  // namespace foveola
