// Standing back until all of something is in the picture.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/base/angles.h"
#include "renderer/scene/scene.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// The nearest place from which a camera that looks along `heading` with the horizon level has all
/// that was included in its picture, in the middle, with a margin around.
class Framing {
 public:
  /// field_of_view: the picture's; its lens is ignored.
  Framing(const AzimuthElevation& heading, const FieldOfView& field_of_view);

  void include(const Vec3& position);
  /// All vertices of an object.
  void include(const Scene& scene, std::uint32_t object);
  /// The eight corners.
  void include(const Bounds& bounds);

  /// Where the camera stands; meaningless before anything was included.
  Vec3 position() const;

 private:
  DVec3 right_, up_, back_;
  std::array<DVec3, 4> sides_;      ///< normals of the pyramid of view, outwards; of no unit length
  std::array<double, 4> furthest_;  ///< the furthest that was included, along each of them
  DVec2 half_size_;                 ///< of the picture without its margin, at distance 1
};

}  // namespace foveola
