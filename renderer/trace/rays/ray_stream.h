// A growing stream of shadow rays, for Embree's ray streams.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <vector>

#include "renderer/base/numbers/lane_columns.h"
#include "renderer/base/numbers/lanes.h"
#include "renderer/base/vec.h"

namespace foveola {

/// A growing column of numbers, written eight at a time.
template <typename Number>
class GrowingColumn {
 public:
  Number& operator[](std::size_t i) { return numbers_[i]; }
  const Number& operator[](std::size_t i) const { return numbers_[i]; }
  Number* data() { return numbers_.data(); }

  /// Resizes the column. Numbers never written are `otherwise`, others may be anything.
  void resize(std::size_t size, Number otherwise = {}) { numbers_.resize(size, otherwise); }

  /// Writes all eight lanes.
  template <typename Lanes>
  void store(std::size_t first, const Lanes& lanes) {
    static_assert(sizeof(lanes) == lane_count * sizeof(Number));
    std::memcpy(&numbers_[first], &lanes, sizeof(lanes));
  }

 private:
  std::vector<Number> numbers_;
};

/// Three columns, of vectors or colours.
class GrowingVectors {
 public:
  Vec3 operator[](std::size_t i) const { return {axes_[0][i], axes_[1][i], axes_[2][i]}; }
  /// axis: 0 to 2.
  float* data(std::size_t axis) { return axes_[axis].data(); }

  void resize(std::size_t size) {
    for (GrowingColumn<float>& axis : axes_) {
      axis.resize(size);
    }
  }
  void put(std::size_t i, const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) {
      axes_[static_cast<std::size_t>(axis)][i] = v[axis];
    }
  }
  void store(std::size_t first, const LanePacking& packing, const Vec3s& lanes) {
    axes_[0].store(first, packing(lanes.x));
    axes_[1].store(first, packing(lanes.y));
    axes_[2].store(first, packing(lanes.z));
  }

 private:
  std::array<GrowingColumn<float>, 3> axes_;
};

/// Shadow rays from t = 0 (see Ray). `size`: expected number, before memory grows.
class RayStream {
 public:
  explicit RayStream(std::size_t size) { resize(size + lane_count); }

  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

  /// Adds the packed rays of eight.
  void add(const LanePacking& packing, const Vec3s& origin, const Vec3s& direction,
           const Floats& t_max, const Uints& key) {
    make_room();
    origin_.store(size_, packing, origin);
    direction_.store(size_, packing, direction);
    t_max_.store(size_, packing(t_max));
    key_.store(size_, packing(key));
    size_ += packing.count();
  }
  void add(const Vec3& origin, const Vec3& direction, float t_max, std::uint32_t key) {
    make_room();
    origin_.put(size_, origin);
    direction_.put(size_, direction);
    t_max_[size_] = t_max;
    key_[size_] = key;
    ++size_;
  }

  Vec3 origin(std::size_t i) const { return origin_[i]; }
  Vec3 direction(std::size_t i) const { return direction_[i]; }
  float t_max(std::size_t i) const { return t_max_[i]; }
  std::uint32_t key(std::size_t i) const { return key_[i]; }

  /// Results of RayScene::find_blocked(). Thin transmissive surfaces (see opacity.h) tint and do
  /// not block.
  bool is_blocked(std::size_t i) const { return t_max_[i] < 0.0F; }
  bool met_thin_surface(std::size_t i) const { return met_thin_surface_[i] != 0; }

 private:
  friend class RayScene;

  /// Makes room for eight rays.
  void make_room() {
    if (size_ + lane_count > capacity_) {
      resize(2 * capacity_);
    }
  }
  void resize(std::size_t capacity) {
    capacity_ = capacity;
    origin_.resize(capacity);
    direction_.resize(capacity);
    t_max_.resize(capacity);
    key_.resize(capacity);
    zero_.resize(capacity);
    mask_.resize(capacity, ~0U);
    met_thin_surface_.resize(capacity);
    number_.resize(capacity);
    std::iota(number_.data(), number_.data() + capacity, 0U);
  }

  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
  GrowingVectors origin_, direction_;
  GrowingColumn<float> t_max_;
  GrowingColumn<std::uint32_t> key_;
  // Further inputs of Embree.
  GrowingColumn<float> zero_;
  GrowingColumn<std::uint32_t> mask_, met_thin_surface_;
  GrowingColumn<std::uint32_t> number_;  ///< 0, 1, 2, ...
};

}  // namespace foveola
