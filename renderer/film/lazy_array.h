// An array whose memory costs nothing until it is written.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

#include <sys/mman.h>

namespace foveola {

struct UnmapArray {
  std::size_t bytes = 0;
  void operator()(void* memory) const { ::munmap(memory, bytes); }
};

/// An array of items whose bytes are all zero. The system gives memory, page by page, where one is
/// first written, whatever the array's size.
template <typename Item>
using LazyArray = std::unique_ptr<Item[], UnmapArray>;

/// count: at least 1. Throws std::bad_alloc.
template <typename Item>
LazyArray<Item> make_lazy_array(std::size_t count) {
  static_assert(std::is_trivially_copyable_v<Item>);  // so that zeros make one
  const std::size_t bytes = count * sizeof(Item);
  void* const mapped = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (mapped == MAP_FAILED) {
    throw std::bad_alloc();
  }
  return LazyArray<Item>(static_cast<Item*>(mapped), UnmapArray{bytes});
}

}  // namespace foveola
