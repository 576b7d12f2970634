#include "renderer/view/view_sampler.h"

#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/view/acuity.h"
#include "renderer/view/eccentricity_table.h"
#include "renderer/view/equirect.h"

namespace foveola {
namespace {

/// OD: every pixel of the equirect image alike.
class ImageSampler final : public ViewSampler {
 public:
  void aim(const Aim&) override {}

  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      samples[i] = {.direction = direction_from_equirect(points[i]), .image = points[i]};
    }
  }

  double density_per_sr(const Vec3& direction) const override {
    return equirect_area_per_sr(direction);
  }
};

/// VP: every part of the display's plane alike.
class ViewportSampler final : public ViewSampler {
 public:
  void aim(const Aim& aim) override { viewport_ = aim.viewport; }

  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 direction = viewport_->direction(points[i]);
      samples[i] = {.direction = direction, .image = equirect_from_direction(direction)};
    }
  }

  double density_per_sr(const Vec3& direction) const override {
    if (!viewport_->project(direction)) {
      return 0.0;
    }
    // A patch of the plane at distance 1 is seen under its area times cos^3.
    const Vec3 forward = viewport_->head() * Vec3(0.0F, 0.0F, -1.0F);
    const double cosine = glm::dot(DVec3(forward), glm::normalize(DVec3(direction)));
    const double plane_area = 4.0 * viewport_->half_size().x * viewport_->half_size().y;
    return 1.0 / (plane_area * cosine * cosine * cosine);
  }

 private:
  std::optional<Viewport> viewport_;
};

/// FV: following the acuity around the gaze.
class FoveatedSampler final : public ViewSampler {
 public:
  void aim(const Aim& aim) override { around_gaze_ = Frame(glm::normalize(aim.gaze)); }

  void sample(std::span<const Vec2> points, std::span<ViewSample> samples) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float eccentricity = eccentricity_rad_(points[i].x);
      const float angle = points[i].y * static_cast<float>(2.0 * std::numbers::pi);
      const float radius = std::sin(eccentricity);
      const Vec3 direction = around_gaze_.to_world(
          {radius * std::cos(angle), radius * std::sin(angle), std::cos(eccentricity)});
      samples[i] = {.direction = direction, .image = equirect_from_direction(direction)};
    }
  }

  double density_per_sr(const Vec3& direction) const override {
    return distribution_.density_per_sr(degrees(angle_between(direction, around_gaze_.normal)));
  }

 private:
  FoveatedDistribution distribution_;
  EccentricityTable eccentricity_rad_{distribution_};
  Frame around_gaze_{Vec3(0.0F, 0.0F, -1.0F)};
};

}  // namespace

const std::vector<std::string>& view_sampler_names() {
  static const std::vector<std::string> names = {"od", "vp", "fv"};
  return names;
}

std::unique_ptr<ViewSampler> make_view_sampler(std::string_view name) {
  if (name == "od") {
    return std::make_unique<ImageSampler>();
  }
  if (name == "vp") {
    return std::make_unique<ViewportSampler>();
  }
  if (name == "fv") {
    return std::make_unique<FoveatedSampler>();
  }
  throw Error("method", fmt::format("there is no sampler '{}'", name),
              fmt::format("choose one of {}", fmt::join(view_sampler_names(), ", ")));
}

}  // namespace foveola
