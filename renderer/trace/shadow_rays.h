// The shadow rays of a block's vertices, side by side.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "renderer/base/lane_columns.h"
#include "renderer/base/lanes.h"
#include "renderer/base/vec.h"
#include "renderer/trace/ray_scene.h"

namespace foveola {

/// Shadow rays, each with what a job gains if it is not blocked. There may be any number: a path
/// that passes thin surfaces leaves one at each.
class ShadowRays {
 public:
  /// expected: the usual number.
  explicit ShadowRays(std::size_t expected) { resize(expected + lane_count); }

  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

  /// Adds those of eight rays that are packed.
  void add(const LanePacking& packing, const Vec3s& origin, const Vec3s& direction,
           const Floats& t_max, const Uints& key, const Vec3s& gain, const Uints& job) {
    make_room();
    store(origin_, packing, origin);
    store(direction_, packing, direction);
    store(t_max_, packing(t_max));
    store(key_, packing(key));
    store(gain_, packing, gain);
    store(job_, packing(job));
    size_ += packing.count();
  }
  /// The ray must begin at its origin.
  void add(const Ray& ray, const Rgb& gain, std::uint32_t job) {
    make_room();
    for (int axis = 0; axis < 3; ++axis) {
      origin_[axis][size_] = ray.origin[axis];
      direction_[axis][size_] = ray.direction[axis];
      gain_[axis][size_] = gain[axis];
    }
    t_max_[size_] = ray.t_max;
    key_[size_] = ray.key;
    job_[size_] = job;
    ++size_;
  }

  /// The eight from `first` on. Those behind the last may be anything.
  RayLanes rays(std::size_t first) const {
    return {load(origin_, first), load(direction_, first), load<Floats>(t_max_, first),
            load<Uints>(key_, first)};
  }
  Rgb gain(std::size_t i) const { return {gain_[0][i], gain_[1][i], gain_[2][i]}; }
  std::uint32_t job(std::size_t i) const { return job_[i]; }

 private:
  using Numbers = std::vector<float>;
  using Vectors = std::array<Numbers, 3>;
  using Integers = std::vector<std::uint32_t>;

  /// For eight more.
  void make_room() {
    if (size_ + lane_count > t_max_.size()) {
      resize(2 * t_max_.size());
    }
  }
  void resize(std::size_t size) {
    for (Vectors* vectors : {&origin_, &direction_, &gain_}) {
      for (Numbers& numbers : *vectors) {
        numbers.resize(size);
      }
    }
    t_max_.resize(size);
    key_.resize(size);
    job_.resize(size);
  }

  template <typename Lanes, typename Column>
  static Lanes load(const Column& column, std::size_t first) {
    Lanes lanes;
    std::memcpy(&lanes, column.data() + first, sizeof(lanes));
    return lanes;
  }
  static Vec3s load(const Vectors& vectors, std::size_t first) {
    return {load<Floats>(vectors[0], first), load<Floats>(vectors[1], first),
            load<Floats>(vectors[2], first)};
  }
  template <typename Column, typename Lanes>
  void store(Column& column, const Lanes& lanes) {
    std::memcpy(column.data() + size_, &lanes, sizeof(lanes));
  }
  void store(Vectors& vectors, const LanePacking& packing, const Vec3s& lanes) {
    store(vectors[0], packing(lanes.x));
    store(vectors[1], packing(lanes.y));
    store(vectors[2], packing(lanes.z));
  }

  std::size_t size_ = 0;
  Vectors origin_, direction_, gain_;
  Numbers t_max_;
  Integers key_, job_;
};

}  // namespace foveola
