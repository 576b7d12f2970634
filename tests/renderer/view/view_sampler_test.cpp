#include "renderer/view/view_sampler.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/base/random.h"
#include "renderer/view/equirect.h"
#include "tests/renderer/view/chi_squared.h"

namespace foveola {
namespace {

struct Looking {
  const char* name;
  double azimuth_deg;
  double elevation_deg;
};

constexpr Looking places[] = {{"ahead", 0.0, 0.0},
                              {"half_up", 70.0, 45.0},
                              {"near_zenith", 30.0, 89.5},
                              {"near_nadir", -100.0, -89.5},
                              {"at_the_seam", 180.0, -10.0}};

Aim aim_at(const Looking& looking) {
  const AzimuthElevation heading{.azimuth_rad = radians(looking.azimuth_deg),
                                 .elevation_rad = radians(looking.elevation_deg)};
  return {.viewport = Viewport(head_orientation(heading), radians(100.0), radians(80.0)),
          .gaze = direction_from(heading)};
}

class EverySampler : public testing::TestWithParam<std::tuple<std::string, Looking>> {
 protected:
  void SetUp() override {
    aim_ = aim_at(std::get<1>(GetParam()));
    sampler_ = make_view_sampler(std::get<0>(GetParam()));
    sampler_->aim(aim_);
  }
  double density(const Vec3& direction) const { return sampler_->density_per_sr(direction); }

  Aim aim_{.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0)};
  std::unique_ptr<ViewSampler> sampler_;
};

// Independent points, since the test supposes independence. With 15 tests Sidak's correction of a
// 1 % level is 1 - 0.99^(1/15) = 0.00067.
TEST_P(EverySampler, FollowsItsDensity) {
  Pcg32 generator(11);
  std::vector<Vec2> points(200'000);
  for (Vec2& point : points) {
    const double x = generator.uniform();
    const double y = generator.uniform();
    point = glm::min(Vec2(x, y), Vec2(0x1.fffffep-1F));
  }
  std::vector<ViewSample> samples(points.size());
  sampler_->sample(points, samples);
  std::vector<Vec3> directions;
  directions.reserve(samples.size());
  for (const ViewSample& sample : samples) {
    directions.push_back(sample.direction);
  }
  const double p = test::chi_squared_p_value(
      directions, [this](const Vec3& d) { return density(d); }, aim_.gaze);
  EXPECT_GT(p, 0.00067);
}

TEST_P(EverySampler, DensityIntegratesToOne) {
  // The edge of a viewport cuts cells, and OD's density is infinite at the poles: 0.5 %.
  EXPECT_NEAR(test::integral_over_sphere([this](const Vec3& d) { return density(d); }, aim_.gaze),
              1.0, 0.005);
}

TEST_P(EverySampler, SamplesAreUnitDirectionsWithTheirImagePositions) {
  std::vector<Vec2> points;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    points.push_back(sobol_2d(i, 5));
  }
  points.insert(points.end(), {{0.0F, 0.0F}, {0x1.fffffep-1F, 0x1.fffffep-1F}});
  std::vector<ViewSample> samples(points.size());
  sampler_->sample(points, samples);
  for (const ViewSample& sample : samples) {
    EXPECT_NEAR(glm::length(sample.direction), 1.0F, 1e-6F);
    EXPECT_GE(sample.image.x, 0.0F);
    EXPECT_LT(sample.image.x, 1.0F);
    EXPECT_GE(sample.image.y, 0.0F);
    EXPECT_LE(sample.image.y, 1.0F);
    EXPECT_LT(glm::distance(direction_from_equirect(sample.image), sample.direction), 2e-6F);
  }
}

INSTANTIATE_TEST_SUITE_P(Everywhere, EverySampler,
                         testing::Combine(testing::ValuesIn(view_sampler_names()),
                                          testing::ValuesIn(places)),
                         [](const testing::TestParamInfo<std::tuple<std::string, Looking>>& test) {
                           return std::get<0>(test.param) + "_" + std::get<1>(test.param).name;
                         });

// The paper's comparison: at the equator 59.35 samples of FV's fovea fall where one of OD's does.
TEST(FoveatedSampler, FovealDensityIs59TimesThatOfOd) {
  const Aim aim = aim_at(places[0]);
  const auto od = make_view_sampler("od");
  const auto fv = make_view_sampler("fv");
  od->aim(aim);
  fv->aim(aim);
  EXPECT_NEAR(fv->density_per_sr(aim.gaze) / od->density_per_sr(aim.gaze), 59.35, 0.005);
}

// Against OD at the horizon, VP on a plane of 100 x 100 degrees has 3.5 times the samples.
TEST(ViewportSampler, CentralDensityIs3Point5TimesThatOfOd) {
  const Aim aim{.viewport = Viewport(head_orientation({}), radians(100.0), radians(100.0))};
  const auto od = make_view_sampler("od");
  const auto vp = make_view_sampler("vp");
  od->aim(aim);
  vp->aim(aim);
  EXPECT_NEAR(vp->density_per_sr(aim.gaze) / od->density_per_sr(aim.gaze), 3.475, 0.005);
}

TEST(ViewportSampler, NothingFallsOutsideTheView) {
  const Aim aim{.viewport = Viewport(head_orientation({}), radians(60.0), radians(40.0))};
  const auto vp = make_view_sampler("vp");
  vp->aim(aim);
  EXPECT_EQ(vp->density_per_sr({0.0F, 0.0F, 1.0F}), 0.0);
  EXPECT_EQ(vp->density_per_sr(direction_from({.azimuth_rad = radians(31.0)})), 0.0);
  EXPECT_GT(vp->density_per_sr(direction_from({.azimuth_rad = radians(29.0)})), 0.0);
  EXPECT_EQ(vp->density_per_sr(direction_from({.elevation_rad = radians(21.0)})), 0.0);
}

TEST(MakeViewSampler, AnUnknownNameListsTheKnownOnes) {
  EXPECT_THAT([] { make_view_sampler("xyz"); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("od, vp, fv")));
}

}  // namespace
}  // namespace foveola
