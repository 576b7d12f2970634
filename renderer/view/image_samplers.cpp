#include "renderer/view/image_samplers.h"

#include <functional>
#include <optional>

#include "renderer/view/equirect.h"
#include "renderer/view/sample_block.h"

namespace foveola {
namespace {

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

}  // namespace foveola
