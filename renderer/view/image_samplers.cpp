#include "renderer/view/image_samplers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "renderer/view/equirect.h"
#include "renderer/view/radial_distribution.h"
#include "renderer/view/sample_block.h"

namespace foveola {
namespace {

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
