// Memory for many small items that are forgotten all at once.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

#include <sys/mman.h>

namespace foveola {

inline constexpr std::size_t huge_page = std::size_t{2} << 20;  ///< bytes

struct FreeMemory {
  void operator()(std::byte* memory) const { std::free(memory); }
};
using HugePage = std::unique_ptr<std::byte[], FreeMemory>;

/// Memory that the system may give as a whole: where samples fall far apart, finding pages and
/// filling them one by one takes longer than the samples. Throws std::bad_alloc.
inline HugePage take_huge_page() {
  auto* memory = static_cast<std::byte*>(std::aligned_alloc(huge_page, huge_page));
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  ::madvise(memory, huge_page, MADV_HUGEPAGE);  // a wish: what it answers does not matter
  return HugePage(memory);
}

/// Hands out items that lie side by side, in the order in which they are asked for, and the same
/// memory again after a clear.
template <typename Item>
class ItemPool {
 public:
  /// Makes room for `count` more items. What is not taken costs no memory of the machine's.
  void reserve(std::size_t count) {
    const std::size_t needed = used_.load(std::memory_order_relaxed) + count;
    while (chunks_.size() * items_in_chunk < needed) {
      chunks_.push_back(take_huge_page());
    }
  }

  /// A new item, of which there is one reserved. Several threads may ask at a time.
  Item* take() {
    static_assert(std::is_trivially_destructible_v<Item>);
    const std::size_t i = used_.fetch_add(1, std::memory_order_relaxed);
    return new (chunks_[i / items_in_chunk].get() + i % items_in_chunk * sizeof(Item)) Item();
  }

  /// Every item is void from now on.
  void clear() { used_ = 0; }

 private:
  static constexpr std::size_t items_in_chunk = huge_page / sizeof(Item);

  std::vector<HugePage> chunks_;
  std::atomic<std::size_t> used_ = 0;
};

}  // namespace foveola
