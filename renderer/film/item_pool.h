// Memory for many small items that are forgotten all at once, of pages of zeros that are ready
// before they are needed.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <mutex>
#include <new>
#include <stop_token>
#include <thread>
#include <type_traits>
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
  static constexpr std::size_t max_ready = 2;
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

/// Hands out items that lie side by side, all zeros, and the same memory again after a clear.
template <typename Item>
class ItemPool {
 private:
  /// Memory for items that nobody has taken.
  struct Run {
    std::byte* begin = nullptr;
    std::byte* end = nullptr;
    bool is_zeros = true;
  };

 public:
  /// pages: where its memory comes from.
  explicit ItemPool(HugePages& pages) : pages_(pages) {}

  /// Takes items for one thread, a run of them at a time from the pool, so that threads hardly meet
  /// there. What it does not hand out goes back. It must be gone before the pool is cleared.
  class Taker {
   public:
    explicit Taker(ItemPool& pool) : pool_(pool) {}
    ~Taker() { pool_.give_back(run_); }
    Taker(const Taker&) = delete;
    Taker& operator=(const Taker&) = delete;

    /// Throws std::bad_alloc.
    Item* take() {
      if (run_.begin == run_.end) {
        run_ = pool_.next_run();
        fill_with_zeros(run_);
      }
      std::byte* const item = run_.begin;
      run_.begin += sizeof(Item);
      return std::launder(reinterpret_cast<Item*>(item));
    }

   private:
    ItemPool& pool_;
    Run run_;
  };

  /// Every item is void from now on.
  void clear() {
    items_used_before_ = std::max(items_used_before_, next_item_);
    next_item_ = 0;
    left_over_.clear();
  }

 private:
  static constexpr std::size_t items_in_chunk = huge_page / sizeof(Item);
  /// A run has as many items as stay in the nearest cache until they are taken.
  static constexpr std::size_t items_in_run = 4096 / sizeof(Item);

  Run next_run() {
    static_assert(std::is_trivially_copyable_v<Item>);  // so that zeros make one
    const std::scoped_lock lock(mutex_);
    if (!left_over_.empty()) {
      const Run run = left_over_.back();
      left_over_.pop_back();
      return run;
    }
    const std::size_t chunk = next_item_ / items_in_chunk;
    if (chunk == chunks_.size()) {
      chunks_.push_back(pages_.take());
    }
    const std::size_t first = next_item_ % items_in_chunk;
    const std::size_t count = std::min(items_in_run, items_in_chunk - first);
    std::byte* const begin = chunks_[chunk].get() + first * sizeof(Item);
    // Runs begin where they began before a clear, so that each as a whole was used or not.
    const bool is_zeros = next_item_ >= items_used_before_;
    next_item_ += count;
    return {.begin = begin, .end = begin + count * sizeof(Item), .is_zeros = is_zeros};
  }

  void give_back(const Run& run) {
    if (run.begin != run.end) {
      const std::scoped_lock lock(mutex_);
      left_over_.push_back(run);
    }
  }

  static void fill_with_zeros(Run& run) {
    if (!run.is_zeros) {
      std::memset(run.begin, 0, static_cast<std::size_t>(run.end - run.begin));
      run.is_zeros = true;
    }
  }

  HugePages& pages_;
  std::mutex mutex_;
  std::vector<HugePage> chunks_;
  std::vector<Run> left_over_;
  std::size_t next_item_ = 0;  ///< the first that is in no run yet
  std::size_t items_used_before_ = 0;
};

}  // namespace foveola
