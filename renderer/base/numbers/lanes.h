// Vectors of eight numbers (SIMD lanes), and 3D vectors of them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "renderer/base/vec.h"

// Lanes pass between files that are all compiled for the same processor: the AVX calling convention
// makes no difference.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace foveola {

inline constexpr std::size_t lane_count = 8;

/// The vector types of GCC and Clang: arithmetic and comparisons work per lane, and accept single
/// numbers for all lanes. A comparison gives a mask with all bits of a lane or none; `mask ? a : b`
/// chooses per lane.
using Floats = float __attribute__((vector_size(lane_count * sizeof(float))));
using Ints = std::int32_t __attribute__((vector_size(lane_count * sizeof(float))));
using Uints = std::uint32_t __attribute__((vector_size(lane_count * sizeof(float))));
using LaneMask = Ints;

/// One value in all lanes.
inline Floats all_lanes(float value) { return Floats{} + value; }

/// One bit per lane, the first lane's lowest.
inline std::uint32_t bits_of(const LaneMask& mask) {
#ifdef __AVX__
  return static_cast<std::uint32_t>(__builtin_ia32_movmskps256(reinterpret_cast<Floats>(mask)));
#else
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < lane_count; ++i) {
    bits |= (static_cast<std::uint32_t>(mask[i]) & 1U) << i;
  }
  return bits;
#endif
}

/// The mask of the lanes whose bit is set.
inline LaneMask mask_of(std::uint32_t bits) {
  constexpr Uints bit_of_lane = {1, 2, 4, 8, 16, 32, 64, 128};
  return LaneMask((bit_of_lane & bits) != 0U);
}

inline bool any_lane(bool mask) { return mask; }
inline bool any_lane(const LaneMask& mask) { return bits_of(mask) != 0; }

/// Calls visit(lane) for the lanes whose bit is set, from the first.
template <typename Visit>
void for_each_lane(std::uint32_t bits, const Visit& visit) {
  for (std::uint32_t left = bits; left != 0; left &= left - 1) {
    visit(static_cast<std::size_t>(__builtin_ctz(left)));
  }
}
/// Calls visit(lane) for the lanes of a mask.
template <typename Visit>
void for_each_lane(const LaneMask& mask, const Visit& visit) {
  for_each_lane(bits_of(mask), visit);
}

// The functions below exist for single numbers too, so that a formula is written once for both.
// Templates on both are declared inline: GCC inlines fewer of them otherwise.

inline float square_root(float x) { return std::sqrt(x); }
inline Floats square_root(const Floats& x) {
  Floats root;
  for (std::size_t i = 0; i < lane_count; ++i) {
    root[i] = std::sqrt(x[i]);
  }
  return root;
}

inline float smaller(float a, float b) { return a < b ? a : b; }
inline Floats smaller(const Floats& a, const Floats& b) { return a < b ? a : b; }
inline float larger(float a, float b) { return a > b ? a : b; }
inline Floats larger(const Floats& a, const Floats& b) { return a > b ? a : b; }

inline Floats smaller(const Floats& a, float b) { return smaller(a, all_lanes(b)); }
inline Floats larger(const Floats& a, float b) { return larger(a, all_lanes(b)); }

inline float magnitude(float x) { return std::abs(x); }
inline Floats magnitude(const Floats& x) {
  return reinterpret_cast<Floats>(reinterpret_cast<Ints>(x) & 0x7fffffff);
}

/// The magnitude of `x` with the sign of `sign`.
inline float with_sign(float x, float sign) { return std::copysign(x, sign); }
inline Floats with_sign(const Floats& x, const Floats& sign) {
  const Ints sign_bit = reinterpret_cast<Ints>(sign) & std::numeric_limits<std::int32_t>::min();
  return reinterpret_cast<Floats>(reinterpret_cast<Ints>(magnitude(x)) | sign_bit);
}

inline Floats with_sign(float x, const Floats& sign) { return with_sign(all_lanes(x), sign); }

inline float nearest_integer(float x) { return std::nearbyint(x); }
inline Floats nearest_integer(const Floats& x) {
  Floats integer;
  for (std::size_t i = 0; i < lane_count; ++i) {
    integer[i] = std::nearbyint(x[i]);
  }
  return integer;
}

inline float chosen(bool condition, float a, float b) { return condition ? a : b; }
inline Floats chosen(const LaneMask& mask, const Floats& a, const Floats& b) {
  return mask ? a : b;
}

/// The next integer towards zero, of |x| < 2^31.
inline std::int32_t truncated(float x) { return static_cast<std::int32_t>(x); }
inline Ints truncated(const Floats& x) { return __builtin_convertvector(x, Ints); }
inline float floats_of(std::int32_t x) { return static_cast<float>(x); }
inline Floats floats_of(const Ints& x) { return __builtin_convertvector(x, Floats); }

/// The nearest integer in [0, most].
inline std::int32_t clamped(std::int32_t x, std::int32_t most) {
  return x < 0 ? 0 : (x < most ? x : most);
}
inline Ints clamped(const Ints& x, std::int32_t most) {
  const Ints not_above = x < most ? x : Ints{} + most;
  return not_above > 0 ? not_above : Ints{};
}

/// An array whose lanes are written or read one by one, without a round trip for each.
template <typename Number, typename Vector>
struct alignas(lane_count * sizeof(float)) LanesOf : std::array<Number, lane_count> {
  static_assert(sizeof(Vector) == lane_count * sizeof(Number));

  Vector load() const {
    Vector lanes;
    __builtin_memcpy(&lanes, this->data(), sizeof(lanes));
    return lanes;
  }
  void store(const Vector& lanes) { __builtin_memcpy(this->data(), &lanes, sizeof(lanes)); }
};
using FloatLanes = LanesOf<float, Floats>;
using UintLanes = LanesOf<std::uint32_t, Uints>;

/// Eight rows of a matrix, which become its columns.
using LaneRows = std::array<Floats, lane_count>;
inline LaneRows transposed(const LaneRows& rows) {
  LaneRows pairs;  // of rows, and then of columns
  LaneRows fours;
  LaneRows columns;
  for (std::size_t i = 0; i < lane_count; i += 2) {
    pairs[i] = __builtin_shufflevector(rows[i], rows[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
    pairs[i + 1] = __builtin_shufflevector(rows[i], rows[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
  }
  for (std::size_t i = 0; i < lane_count; i += 4) {
    for (std::size_t j = 0; j < 2; ++j) {
      const Floats& upper = pairs[i + j];
      const Floats& lower = pairs[i + j + 2];
      fours[i + 2 * j] = __builtin_shufflevector(upper, lower, 0, 1, 8, 9, 4, 5, 12, 13);
      fours[i + 2 * j + 1] = __builtin_shufflevector(upper, lower, 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  for (std::size_t i = 0; i < lane_count / 2; ++i) {
    columns[i] = __builtin_shufflevector(fours[i], fours[i + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    columns[i + 4] = __builtin_shufflevector(fours[i], fours[i + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
  return columns;
}

struct Vec2s {
  Floats x, y;
};

struct Vec2Lanes {
  FloatLanes x, y;

  Vec2s load() const { return {x.load(), y.load()}; }
  void store(const Vec2s& lanes) {
    x.store(lanes.x);
    y.store(lanes.y);
  }
  Vec2 at(std::size_t lane) const { return {x[lane], y[lane]}; }
};

/// Vectors or colours, one per lane.
struct Vec3s {
  Floats x, y, z;

  friend Vec3s operator+(const Vec3s& a, const Vec3s& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Vec3s operator-(const Vec3s& a, const Vec3s& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Vec3s operator-(const Vec3s& a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3s operator*(const Vec3s& a, const Vec3s& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
  }
  friend Vec3s operator*(const Floats& s, const Vec3s& v) { return {s * v.x, s * v.y, s * v.z}; }
  friend Vec3s operator*(float s, const Vec3s& v) { return {s * v.x, s * v.y, s * v.z}; }
  /// With one division instead of three.
  friend Vec3s operator/(const Vec3s& v, const Floats& s) { return (1.0F / s) * v; }
};

inline Vec3s all_lanes(const Vec3& v) { return {all_lanes(v.x), all_lanes(v.y), all_lanes(v.z)}; }
inline Floats dot(const Vec3s& a, const Vec3s& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3s cross(const Vec3s& a, const Vec3s& b) {
  return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}
inline Vec3 normalized(const Vec3& v) { return glm::normalize(v); }
inline Vec3s normalized(const Vec3s& v) { return (1.0F / square_root(dot(v, v))) * v; }
inline Vec3 magnitude(const Vec3& v) { return glm::abs(v); }
inline Vec3s magnitude(const Vec3s& v) { return {magnitude(v.x), magnitude(v.y), magnitude(v.z)}; }
inline Vec3 larger(const Vec3& a, const Vec3& b) { return glm::max(a, b); }
inline Vec3s larger(const Vec3s& a, const Vec3s& b) {
  return {larger(a.x, b.x), larger(a.y, b.y), larger(a.z, b.z)};
}
inline Floats max_component(const Vec3s& v) { return larger(v.x, larger(v.y, v.z)); }
inline LaneMask is_finite(const Vec3s& v) {
  const Vec3s size = magnitude(v);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  return (size.x < infinity) & (size.y < infinity) & (size.z < infinity);
}
inline Vec3 chosen(bool condition, const Vec3& a, const Vec3& b) { return condition ? a : b; }
inline Vec3s chosen(const LaneMask& mask, const Vec3s& a, const Vec3s& b) {
  return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}

/// Doubles, for sums beyond a float's precision.
using Doubles = double __attribute__((vector_size(lane_count * sizeof(double))));
using DoubleMask = std::int64_t __attribute__((vector_size(lane_count * sizeof(double))));

inline double wide(float x) { return x; }
inline Doubles wide(const Floats& x) { return __builtin_convertvector(x, Doubles); }
inline float narrow(double x) { return static_cast<float>(x); }
inline Floats narrow(const Doubles& x) { return __builtin_convertvector(x, Floats); }
inline double square_root(double x) { return std::sqrt(x); }
inline Doubles square_root(const Doubles& x) {
  Doubles root;
  for (std::size_t i = 0; i < lane_count; ++i) {
    root[i] = std::sqrt(x[i]);
  }
  return root;
}
inline double magnitude(double x) { return std::abs(x); }
inline Doubles magnitude(const Doubles& x) {
  return reinterpret_cast<Doubles>(reinterpret_cast<DoubleMask>(x) &
                                   std::numeric_limits<std::int64_t>::max());
}

/// Types that belong to a number type: float or Floats.
template <typename Number>
struct TypesOf;
template <>
struct TypesOf<float> {
  using Wide = double;
  using Int = std::int32_t;
  using Mask = bool;
  using Vector2 = Vec2;
  using Vector3 = Vec3;
};
template <>
struct TypesOf<Floats> {
  using Wide = Doubles;
  using Int = Ints;
  using Mask = LaneMask;
  using Vector2 = Vec2s;
  using Vector3 = Vec3s;
};
template <typename Number>
using WideOf = typename TypesOf<Number>::Wide;
template <typename Number>
using IntOf = typename TypesOf<Number>::Int;
template <typename Number>
using MaskOf = typename TypesOf<Number>::Mask;
template <typename Number>
using Vec2Of = typename TypesOf<Number>::Vector2;
template <typename Number>
using Vec3Of = typename TypesOf<Number>::Vector3;

struct Vec3Lanes {
  FloatLanes x, y, z;

  Vec3s load() const { return {x.load(), y.load(), z.load()}; }
  void store(const Vec3s& lanes) {
    x.store(lanes.x);
    y.store(lanes.y);
    z.store(lanes.z);
  }
  void put(std::size_t lane, const Vec3& v) {
    x[lane] = v.x;
    y[lane] = v.y;
    z[lane] = v.z;
  }
  Vec3 at(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
};

}  // namespace foveola
