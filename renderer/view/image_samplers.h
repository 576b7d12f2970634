// Samplers without a gaze: over the image, a rectangle of it (which may cross its seam), the
// viewport or a picture; and around a pointer.
#pragma once

#include <memory>
#include <optional>

#include "renderer/base/angles.h"
#include "renderer/view/view_sampler.h"
#include "renderer/view/viewport.h"

namespace foveola {

struct ImageRectangle {
  double u_begin = 0.0;  ///< in [0, 1)
  double width = 1.0;    ///< in (0, 1]; u_begin + width > 1 continues at u = 0
  double v_begin = 0.0;  ///< 0 <= v_begin < v_end <= 1
  double v_end = 1.0;

  double area() const { return width * (v_end - v_begin); }
  /// Maps a point of the unit square to the rectangle; u in [0, 1).
  Vec2 place(const Vec2& point) const;
  bool contains(const Vec2& image) const;
  bool operator==(const ImageRectangle&) const = default;
};

/// The smallest rectangle that holds the whole viewport: full width if it contains a pole. With a
/// lens, whose edges are approximated by 1024 segments, it may miss a sliver of less than 1e-6.
ImageRectangle bounding_rectangle(const Viewport& viewport);

/// Uniform over the pixels of a rectangle of the equirect image; the whole image is OD.
std::unique_ptr<ViewSampler> make_rectangle_sampler(const ImageRectangle& rectangle);

/// VP as the image rectangle that bounds the viewport.
std::unique_ptr<ViewSampler> make_viewport_rectangle_sampler();

/// VP: uniform over the display's plane.
std::unique_ptr<ViewSampler> make_viewport_sampler();

/// Uniform over the plane of the aimed viewport. A sample's image position is its place in the
/// picture, (0, 0) at the top left, and not on the sphere. Films made with it are pictures: their
/// pixels are not those of a 360-degree image.
std::unique_ptr<ViewSampler> make_picture_sampler();

/// A truncated Gaussian around the pointer in planar degrees.
class PointerSampler final : public ViewSampler {
 public:
  /// radius_deg: the standard deviation along any line through the pointer, positive. cutoff_deg in
  /// (0, 180). fixed: a unit direction that replaces the pointer.
  PointerSampler(double radius_deg, double cutoff_deg, const std::optional<Vec3>& fixed);

  void aim(const Aim& aim) override;
  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override;
  double density_per_sr(const Vec3& direction) const override;

 private:
  double radius_deg_;
  double cutoff_deg_;
  double share_;  ///< share of the Gaussian within the cut-off
  std::optional<Vec3> fixed_;
  Frame around_{Vec3(0.0F, 0.0F, -1.0F)};
};

}  // namespace foveola
