#include "renderer/view/image_samplers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "renderer/view/equirect.h"
#include "renderer/view/radial_distribution.h"
#include "renderer/view/sample_block.h"

namespace foveola {
namespace {

using std::numbers::pi;

/// Widens [low, high] by the elevations of the great circle's arc from a to b, less than half of
/// it.
void add_arc(const DVec3& a, const DVec3& b, double& low_rad, double& high_rad) {
  const auto add = [&](const DVec3& direction) {
    const double elevation = std::asin(std::clamp(direction.y, -1.0, 1.0));
    low_rad = std::min(low_rad, elevation);
    high_rad = std::max(high_rad, elevation);
  };
  add(a);
  add(b);
  // The circle's highest point, and its lowest opposite, count where they lie between a and b.
  const DVec3 axis = glm::normalize(glm::cross(a, b));
  const DVec3 highest = DVec3(0.0, 1.0, 0.0) - axis.y * axis;
  for (const double sign : {1.0, -1.0}) {
    const DVec3 extreme = sign * highest;
    const bool is_after_a = glm::dot(glm::cross(a, extreme), axis) > 0.0;
    const bool is_before_b = glm::dot(glm::cross(extreme, b), axis) > 0.0;
    if (is_after_a && is_before_b) {
      add(glm::normalize(extreme));
    }
  }
}

/// Directions along the view's edge, clockwise from its top left corner, joined by great circles.
/// Edges under a lens are curved, and approximated by many short ones.
std::vector<DVec3> outline(const Viewport& viewport) {
  const int steps = viewport.lens() == RadialLens{} ? 1 : 256;
  constexpr std::array<Vec2, 4> plane{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::vector<DVec3> directions;
  for (std::size_t edge = 0; edge < plane.size(); ++edge) {
    for (int i = 0; i < steps; ++i) {
      const Vec2 along = glm::mix(plane[edge], plane[(edge + 1) % plane.size()],
                                  static_cast<float>(i) / static_cast<float>(steps));
      directions.push_back(glm::normalize(DVec3(viewport.direction(along))));
    }
  }
  return directions;
}

class PictureSampler final : public ViewSampler {
 public:
  void aim(const Aim& aim) override { viewport_ = aim.viewport; }

  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      samples[i] = {.direction = viewport_->direction(points[i]), .image = points[i]};
    }
  }

  bool keeps_points() const override { return true; }

  double density_per_sr(const Vec3& direction) const override {
    const std::optional<Vec2> plane = viewport_->project(direction);
    return plane ? 1.0 / viewport_->sr_per_area(*plane) : 0.0;
  }

 private:
  std::optional<Viewport> viewport_;
};

class RectangleSampler : public ViewSampler {
 public:
  explicit RectangleSampler(const ImageRectangle& rectangle) : rectangle_(rectangle) {}

  void aim(const Aim&) override {}

  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override {
    sample_places(points, [this](const Vec2& point) { return rectangle_.place(point); }, samples);
  }

  bool keeps_points() const override { return rectangle_ == ImageRectangle{}; }

  double density_per_sr(const Vec3& direction) const override {
    return rectangle_.contains(equirect_from_direction(direction))
               ? equirect_area_per_sr(direction) / rectangle_.area()
               : 0.0;
  }

 protected:
  ImageRectangle rectangle_;
};

class ViewportRectangleSampler final : public RectangleSampler {
 public:
  ViewportRectangleSampler() : RectangleSampler({}) {}
  void aim(const Aim& aim) override { rectangle_ = bounding_rectangle(aim.viewport); }
};

class ViewportSampler final : public ViewSampler {
 public:
  void aim(const Aim& aim) override {
    viewport_ = aim.viewport;
    seen_ = aim.seen;
  }

  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override {
    const auto direction_of = [viewport = *viewport_](const Vec2& point) {
      return viewport.direction(point);
    };
    if (seen_) {
      const auto place = [this](const Vec2& point) { return seen_->place(point); };
      sample_blocks(points, point_by_point(place), direction_of, samples);
    } else {
      sample_blocks(points, point_by_point(std::identity()), direction_of, samples);
    }
  }

  double density_per_sr(const Vec3& direction) const override {
    const std::optional<Vec2> plane = viewport_->project(direction);
    if (!plane || (seen_ && !seen_->contains(*plane))) {
      return 0.0;
    }
    return 1.0 / (viewport_->sr_per_area(*plane) * (seen_ ? seen_->share() : 1.0));
  }

 private:
  std::optional<Viewport> viewport_;
  std::shared_ptr<const SeenPart> seen_;
};

}  // namespace

Vec2 ImageRectangle::place(const Vec2& point) const {
  const double u = u_begin + width * static_cast<double>(point.x);
  const double v = v_begin + (v_end - v_begin) * static_cast<double>(point.y);
  // Rounding to float can reach 1, which is the seam's other side.
  const auto wrapped = static_cast<float>(u - std::floor(u));
  return {wrapped < 1.0F ? wrapped : 0.0F, static_cast<float>(v)};
}

bool ImageRectangle::contains(const Vec2& image) const {
  const double along = image.x - u_begin;
  return along - std::floor(along) <= width && image.y >= v_begin && image.y <= v_end;
}

ImageRectangle bounding_rectangle(const Viewport& viewport) {
  const std::vector<DVec3> corners = outline(viewport);
  double low_rad = pi / 2.0;
  double high_rad = -pi / 2.0;
  // Azimuths relative to the first corner. Along an edge they change by less than half a turn.
  double azimuth_rad = 0.0;
  double left_rad = 0.0;
  double right_rad = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const DVec3& a = corners[i];
    const DVec3& b = corners[(i + 1) % corners.size()];
    add_arc(a, b, low_rad, high_rad);
    azimuth_rad += std::atan2(b.x * -a.z + b.z * a.x, a.x * b.x + a.z * b.z);
    left_rad = std::min(left_rad, azimuth_rad);
    right_rad = std::max(right_rad, azimuth_rad);
  }
  ImageRectangle rectangle{.v_begin = 0.5 - high_rad / pi, .v_end = 0.5 - low_rad / pi};
  const bool goes_around_a_pole = std::abs(azimuth_rad) > pi;
  if (goes_around_a_pole) {
    const Vec3 middle = viewport.direction({0.5F, 0.5F});
    (middle.y > 0.0F ? rectangle.v_begin : rectangle.v_end) = middle.y > 0.0F ? 0.0 : 1.0;
    return rectangle;
  }
  const double first = std::atan2(corners[0].x, -corners[0].z);
  const double u = 0.5 + (first + left_rad) / (2.0 * pi);
  rectangle.u_begin = u - std::floor(u);
  rectangle.width = (right_rad - left_rad) / (2.0 * pi);
  return rectangle;
}

std::unique_ptr<ViewSampler> make_rectangle_sampler(const ImageRectangle& rectangle) {
  return std::make_unique<RectangleSampler>(rectangle);
}

std::unique_ptr<ViewSampler> make_viewport_rectangle_sampler() {
  return std::make_unique<ViewportRectangleSampler>();
}

std::unique_ptr<ViewSampler> make_viewport_sampler() { return std::make_unique<ViewportSampler>(); }

std::unique_ptr<ViewSampler> make_picture_sampler() { return std::make_unique<PictureSampler>(); }

PointerSampler::PointerSampler(double radius_deg, double cutoff_deg,
                               const std::optional<Vec3>& fixed)
    : radius_deg_(radius_deg),
      cutoff_deg_(cutoff_deg),
      share_(-std::expm1(-0.5 * std::pow(cutoff_deg / radius_deg, 2))),
      fixed_(fixed) {}

void PointerSampler::aim(const Aim& aim) {
  around_ = Frame(fixed_.value_or(glm::normalize(aim.pointer.value_or(aim.gaze))));
}

void PointerSampler::sample(std::span<const Vec2> points, std::span<ViewSample> samples) const {
  constexpr double turns_per_degree = 1.0 / 360.0;
  const double scale = radius_deg_ * turns_per_degree;
  const double cutoff = cutoff_deg_ * turns_per_degree;
  // The radius of a two-dimensional Gaussian has an inverse in closed form (Box and Muller 1958).
  // In double: the rare samples far away depend on the last bits of u.
  const auto polar = [&](const Vec2& point) {
    const double eccentricity = scale * std::sqrt(-2.0 * std::log1p(-share_ * point.x));
    return Vec2(static_cast<float>(std::min(eccentricity, cutoff)), point.y);
  };
  sample_around(around_, points, point_by_point(polar), samples);
}

double PointerSampler::density_per_sr(const Vec3& direction) const {
  const double e = degrees(angle_between(direction, around_.normal));
  if (e > cutoff_deg_) {
    return 0.0;
  }
  const double t = e / radius_deg_;
  const double per_square_degree =
      std::exp(-0.5 * t * t) / (2.0 * std::numbers::pi * radius_deg_ * radius_deg_ * share_);
  return foveola::density_per_sr(per_square_degree, e, EccentricityMeasure::planar);
}

}  // namespace foveola
