// Levels of a pyramid over the sphere, laid out for reading with complete neighbours, in lazily
// allocated memory.
#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include <sys/mman.h>

namespace foveola {

struct UnmapArray {
  std::size_t bytes = 0;
  void operator()(void* memory) const { ::munmap(memory, bytes); }
};

/// An array of items whose bytes are all zero. The system allocates each page at its first write,
/// whatever the array's size.
template <typename Item>
using LazyArray = std::unique_ptr<Item[], UnmapArray>;

/// count: at least 1. Throws std::bad_alloc.
template <typename Item>
LazyArray<Item> make_lazy_array(std::size_t count) {
  static_assert(std::is_trivially_copyable_v<Item>);  // all-zero bytes are a valid item
  const std::size_t bytes = count * sizeof(Item);
  void* const mapped = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (mapped == MAP_FAILED) {
    throw std::bad_alloc();
  }
  return LazyArray<Item>(static_cast<Item*>(mapped), UnmapArray{bytes});
}

/// Levels of values over an equirect image, each with a margin of copies: beyond the seam the
/// image's other side, beyond a pole the same row shifted by half an image.
template <typename Value>
class SpherePlanes {
 public:
  /// Level 0 has width x height values, each further level half as many along a side, rounded up.
  /// All bits are zero, and without memory, until set. Throws std::bad_alloc.
  SpherePlanes(int width, int height, int levels) {
    for (int level = 0; level < levels; ++level) {
      planes_.push_back(
          make_plane((width + (1 << level) - 1) >> level, (height + (1 << level) - 1) >> level));
    }
  }

  int levels() const { return static_cast<int>(planes_.size()); }
  int width(int level) const { return plane(level).width; }
  int height(int level) const { return plane(level).height; }

  /// x in [-1, width(level)], y in [-1, height(level)]. Values of a row are contiguous; rows are
  /// stride(level) apart.
  const Value* at(int level, int x, int y) const {
    const Plane& of = plane(level);
    return of.origin + y * of.stride + x;
  }
  std::ptrdiff_t stride(int level) const { return plane(level).stride; }

  /// x in [0, width(level)), y in [0, height(level)); different values may be set concurrently.
  void set(int level, int x, int y, const Value& value) {
    const Plane& of = plane(level);
    assert(x >= 0 && x < of.width && y >= 0 && y < of.height);
    put(of, x, y, value);
    const int opposite = (x + of.width - of.width / 2) % of.width;
    if (y == 0) {
      put(of, opposite, -1, value);
    }
    if (y == of.height - 1) {
      put(of, opposite, of.height, value);
    }
  }

 private:
  struct Plane {
    int width;
    int height;
    std::ptrdiff_t stride;
    LazyArray<Value> memory;
    Value* origin;  ///< the cell (0, 0)
  };

  static Plane make_plane(int width, int height) {
    const std::ptrdiff_t stride = width + 2;
    LazyArray<Value> memory =
        make_lazy_array<Value>(static_cast<std::size_t>(stride) * (height + 2));
    Value* const origin = memory.get() + stride + 1;
    return {width, height, stride, std::move(memory), origin};
  }

  /// Writes the value there, and its copy beyond the seam.
  static void put(const Plane& of, int x, int y, const Value& value) {
    Value* const row = of.origin + y * of.stride;
    row[x] = value;
    if (x == 0) {
      row[of.width] = value;
    }
    if (x == of.width - 1) {
      row[-1] = value;
    }
  }

  const Plane& plane(int level) const { return planes_[static_cast<std::size_t>(level)]; }

  std::vector<Plane> planes_;
};

}  // namespace foveola
