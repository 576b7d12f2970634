// Memory for many small items that are freed all at once, from zeroed pages prepared in advance.
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

/// Allocates zeroed huge pages. For scattered samples, mapping small pages one by one takes longer
/// than the samples. A huge page takes a tenth of a millisecond, and several if a virtual machine
/// must get its memory from the host. A thread can therefore prepare the next ones.
class HugePages {
 public:
  /// Maximum number of prepared pages: the cost of pages that are never taken.
  static constexpr std::size_t max_ready = 2;
  /// The background thread starts after this many calls of take().
  static constexpr std::size_t taken_without_thread = 3;

  /// Thread-safe. Throws std::bad_alloc.
  HugePage take();

  /// Starts a thread that prepares pages for the next calls of take(), and returns at once.
  void make_ready();

  /// Number of prepared pages.
  std::size_t ready() const;

 private:
  void make_pages(const std::stop_token& stop);

  mutable std::mutex mutex_;
  std::size_t taken_ = 0;
  std::vector<HugePage> ready_;
  std::condition_variable_any are_wanted_;
  std::jthread maker_;  ///< last: it ends before the members that it uses
};

/// Allocates contiguous zeroed items; reuses its memory after a clear.
template <typename Item>
class ItemPool {
 private:
  /// Memory for unused items.
  struct Run {
    std::byte* begin = nullptr;
    std::byte* end = nullptr;
    bool is_zeros = true;
  };

 public:
  /// pages: the source of its memory.
  explicit ItemPool(HugePages& pages) : pages_(pages) {}

  /// Takes items for one thread, a run at a time from the pool, to avoid contention. Unused items
  /// are returned. It must be destroyed before the pool is cleared.
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

  /// Makes every item void.
  void clear() {
    items_used_before_ = std::max(items_used_before_, next_item_);
    next_item_ = 0;
    left_over_.clear();
  }

 private:
  static constexpr std::size_t items_in_chunk = huge_page / sizeof(Item);
  /// Number of items in a run: as many as stay in the nearest cache until they are taken.
  static constexpr std::size_t items_in_run = 4096 / sizeof(Item);

  Run next_run() {
    static_assert(std::is_trivially_copyable_v<Item>);  // all-zero bytes are a valid item
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
    // Runs begin at the same items after a clear, so that a run was used as a whole or not at all.
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
  std::size_t next_item_ = 0;  ///< first item outside all runs
  std::size_t items_used_before_ = 0;
};

}  // namespace foveola
