// Long columns of numbers that are read and written eight at a time, and compacted without gaps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "renderer/base/numbers/lanes.h"

namespace foveola {

/// Moves selected lanes of eight to the front, in their order; the lanes behind them are undefined.
class LanePacking {
 public:
  /// bits: one per lane, set for the lanes that stay.
  explicit LanePacking(std::uint32_t bits)
      : count_(static_cast<std::size_t>(__builtin_popcount(bits))) {
    std::array<std::uint8_t, lane_count> from;
    __builtin_memcpy(from.data(), lanes_in_front[bits].data(), sizeof(from));
    for (std::size_t i = 0; i < lane_count; ++i) {
      from_[i] = from[i];
    }
  }

  /// Number of lanes that stay.
  std::size_t count() const { return count_; }

  Floats operator()(const Floats& lanes) const {
#ifdef __AVX2__
    return __builtin_ia32_permvarsf256(lanes, from_);
#else
    Floats packed;
    for (std::size_t i = 0; i < lane_count; ++i) {
      packed[i] = lanes[from_[i]];
    }
    return packed;
#endif
  }
  Uints operator()(const Uints& lanes) const {
    return reinterpret_cast<Uints>((*this)(reinterpret_cast<const Floats&>(lanes)));
  }

 private:
  using Order = std::array<std::uint8_t, lane_count>;

  static constexpr std::array<Order, 1U << lane_count> all_orders() {
    std::array<Order, 1U << lane_count> orders{};
    for (std::size_t bits = 0; bits < orders.size(); ++bits) {
      std::size_t count = 0;
      for (std::size_t lane = 0; lane < lane_count; ++lane) {
        if ((bits >> lane & 1U) != 0) {
          orders[bits][count++] = static_cast<std::uint8_t>(lane);
        }
      }
    }
    return orders;
  }
  static const std::array<Order, 1U << lane_count> lanes_in_front;

  Ints from_;
  std::size_t count_;
};

inline constexpr std::array<LanePacking::Order, 1U << lane_count> LanePacking::lanes_in_front =
    LanePacking::all_orders();

/// A column of `capacity` numbers, a multiple of the number of lanes.
template <typename Number, typename Vector, std::size_t capacity>
struct alignas(sizeof(Vector)) ColumnOf : std::array<Number, capacity> {
  static_assert(sizeof(Vector) == lane_count * sizeof(Number));
  static_assert(capacity % lane_count == 0);

  Vector load(std::size_t first) const {
    Vector lanes;
    __builtin_memcpy(&lanes, this->data() + first, sizeof(lanes));
    return lanes;
  }
  void store(std::size_t first, const Vector& lanes) {
    __builtin_memcpy(this->data() + first, &lanes, sizeof(lanes));
  }
  /// Stores the lanes of the mask; leaves the others unchanged.
  void store(std::size_t first, const LaneMask& mask, const Vector& lanes) {
    store(first, mask ? lanes : load(first));
  }
  /// Moves the staying lanes of the eight at `first` to `to`, which is not behind `first`.
  void move(std::size_t first, const LanePacking& packing, std::size_t to) {
    store(to, packing(load(first)));
  }
};

template <std::size_t capacity>
using FloatColumn = ColumnOf<float, Floats, capacity>;
template <std::size_t capacity>
using UintColumn = ColumnOf<std::uint32_t, Uints, capacity>;

/// Vectors or colours.
template <std::size_t capacity>
struct Vec3Columns {
  FloatColumn<capacity> x, y, z;

  void fill(const Vec3& v) {
    x.fill(v.x);
    y.fill(v.y);
    z.fill(v.z);
  }
  Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
  void put(std::size_t i, const Vec3& v) {
    x[i] = v.x;
    y[i] = v.y;
    z[i] = v.z;
  }
  Vec3s load(std::size_t first) const { return {x.load(first), y.load(first), z.load(first)}; }
  void store(std::size_t first, const LaneMask& mask, const Vec3s& lanes) {
    x.store(first, mask, lanes.x);
    y.store(first, mask, lanes.y);
    z.store(first, mask, lanes.z);
  }
  void move(std::size_t first, const LanePacking& packing, std::size_t to) {
    x.move(first, packing, to);
    y.move(first, packing, to);
    z.move(first, packing, to);
  }
};

}  // namespace foveola
