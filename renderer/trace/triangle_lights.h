// Emissive triangles as light sources, drawn by their power.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "renderer/scene/scene.h"
#include "renderer/trace/alias_table.h"
#include "renderer/trace/triangle.h"

namespace foveola {

/// Every triangle that shines is drawn with its share of the power and sampled uniformly over its
/// area. A textured emitter counts with its texture's mean, so all triangles of one mesh have the
/// same density per area. Triangles without area, or that are not finite, never shine.
class TriangleLights {
 public:
  /// The scene must outlive this object.
  explicit TriangleLights(const Scene& scene);

  bool empty() const { return emitters_.empty(); }

  /// The luminous power of all of them, in radiance times square metre times steradian.
  double power() const { return power_; }

  struct Sample {
    Vec3 point{0.0F};  ///< just off the triangle, on the receiver's side
    float pdf = 0.0F;  ///< per steradian at the receiver
    Rgb radiance{0.0F};
  };
  /// Empty if the point drawn does not shine towards `receiver`. u_choice, u: in the unit square.
  std::optional<Sample> sample(const Vec3& receiver, const Vec2& u_choice, const Vec2& u) const;

  /// The density, per square metre, with which sample() draws points of a mesh's triangles.
  float area_pdf(std::uint32_t mesh) const { return area_pdf_of_mesh_[mesh]; }

 private:
  /// What a sample needs of a triangle, in one place.
  struct Emitter {
    Triangle triangle;
    Vec3 front_normal;
    float rounding_error;
    std::uint32_t mesh;
    std::uint32_t index;  ///< of the triangle in its mesh
  };

  const Scene& scene_;
  std::vector<Emitter> emitters_;
  std::vector<float> area_pdf_of_mesh_;
  std::optional<AliasTable> choice_;  ///< empty without emitters
  double power_ = 0.0;
};

}  // namespace foveola
