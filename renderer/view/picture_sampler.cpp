#include "renderer/view/picture_sampler.h"

#include <optional>

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

}  // namespace

std::unique_ptr<ViewSampler> make_picture_sampler() { return std::make_unique<PictureSampler>(); }

}  // namespace foveola
