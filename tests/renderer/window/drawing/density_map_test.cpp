#include "renderer/window/drawing/view_overlays.h"
#include "tests/matchers.h"

namespace foveola {
namespace {

/// A sampler of a given density.
class Everywhere final : public ViewSampler {
 public:
  explicit Everywhere(double density_per_sr) : density_per_sr_(density_per_sr) {}
  void aim(const Aim& /*aim*/) override {}
  void sample(std::span<const Vec2> /*points*/, std::span<ViewSample> /*samples*/) const override {}
  double density_per_sr(const Vec3& direction) const override {
    return direction.x < 0.0F ? 0.0 : density_per_sr_;
  }

 private:
  double density_per_sr_;
};

TEST(DensityMapTest, IsALogarithmOfFourDecades) {
  const Viewport viewport(head_orientation({}), radians(90.0), radians(90.0));
  const double uniform = 0.0795774715;  // 1 / (4 pi)
  for (const auto& [density, shown] :
       {std::pair(uniform, 0.5F), std::pair(100.0 * uniform, 1.0F), std::pair(0.01 * uniform, 0.0F),
        std::pair(10.0 * uniform, 0.75F), std::pair(1e6 * uniform, 1.0F),
        std::pair(1e-6 * uniform, 0.0F)}) {
    const DensityMap map = density_map(Everywhere(density), viewport, 4, 2);
    EXPECT_THAT(map.values, Pointwise(::testing::FloatNear(1e-5F),
                                      {0.0F, 0.0F, shown, shown, 0.0F, 0.0F, shown, shown}));
  }
}

TEST(DensityMapTest, ColorsGoFromBlueOverGreenToRed) {
  EXPECT_EQ(density_color(0.0F), Rgb(0.0F, 0.0F, 1.0F));
  EXPECT_EQ(density_color(0.5F), Rgb(0.5F, 1.0F, 0.5F));
  EXPECT_EQ(density_color(1.0F), Rgb(1.0F, 0.0F, 0.0F));
}

}  // namespace
}  // namespace foveola
