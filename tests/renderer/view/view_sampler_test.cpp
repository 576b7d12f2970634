#include "renderer/view/view_sampler.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "renderer/view/equirect.h"
#include "tests/renderer/view/chi_squared.h"
#include "tests/renderer/view/every_method.h"
#include "tests/renderer/view/test_images.h"
#include "tests/temporary_folder.h"

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
          .gaze = direction_from(heading),
          .pointer = direction_from(heading)};
}

std::vector<Vec3> random_directions(const ViewSampler& sampler) {
  Pcg32 generator(11);
  std::vector<Vec2> points(200'000);
  for (Vec2& point : points) {
    const float x = unit_float(generator.next());
    point = {x, unit_float(generator.next())};
  }
  std::vector<ViewSample> samples(points.size());
  sampler.sample(points, samples);
  std::vector<Vec3> directions;
  directions.reserve(samples.size());
  for (const ViewSample& sample : samples) {
    directions.push_back(sample.direction);
  }
  return directions;
}

class EverySampler : public testing::TestWithParam<std::tuple<std::string, Looking>> {
 protected:
  void SetUp() override {
    aim_ = aim_at(std::get<1>(GetParam()));
    sampler_ = make_view_sampler(test::with_images(std::get<0>(GetParam()), folder_.path()));
    sampler_->aim(aim_);
  }
  double density(const Vec3& direction) const { return sampler_->density_per_sr(direction); }
  /// Around which the cells of quadratures are small.
  Vec3 middle() const {
    return std::get<0>(GetParam()).starts_with("crop:")
               ? direction_from({.azimuth_rad = radians(170.0), .elevation_rad = radians(50.0)})
               : aim_.gaze;
  }

  test::TemporaryFolder folder_;
  Aim aim_{.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0)};
  std::unique_ptr<ViewSampler> sampler_;
};

/// Those that gather around the gaze.
class GatheringSampler : public EverySampler {};

// Independent points, since the test supposes independence. With 90 tests Sidak's correction of a
// 1 % level is 1 - 0.99^(1/90) = 0.000112.
TEST_P(EverySampler, FollowsItsDensity) {
  const double p = test::chi_squared_p_value(
      random_directions(*sampler_), [this](const Vec3& d) { return density(d); }, middle());
  EXPECT_GT(p, 0.000112);
}

// In rings of a sixth of a degree to 10 degrees: what the cells above hide within their first
// three.
TEST_P(GatheringSampler, FollowsItsDensityInTheFoveaToo) {
  const double p = test::chi_squared_p_value(
      random_directions(*sampler_), [this](const Vec3& d) { return density(d); }, middle(),
      radians(10.0));
  EXPECT_GT(p, 0.000112);
}

TEST_P(EverySampler, DensityIntegratesToOne) {
  // The edge of a viewport cuts cells, and OD's density is infinite at the poles: 0.5 %.
  EXPECT_NEAR(test::integral_over_sphere([this](const Vec3& d) { return density(d); }, middle()),
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

// However samplers go through a batch, several points at a time or block by block.
TEST_P(EverySampler, ABatchIsItsPointsOneByOne) {
  std::vector<Vec2> points;
  for (std::uint64_t i = 0; i < 1500; ++i) {
    points.push_back(sobol_2d(i, 7));
  }
  std::vector<ViewSample> samples(points.size());
  sampler_->sample(points, samples);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ViewSample alone;
    sampler_->sample({&points[i], 1}, {&alone, 1});
    ASSERT_EQ(samples[i].direction, alone.direction) << i;
    ASSERT_EQ(samples[i].image, alone.image) << i;
  }
}

std::string name_of_test(const testing::TestParamInfo<std::tuple<std::string, Looking>>& test) {
  std::string name = std::get<0>(test.param);
  std::replace_if(name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
  return name + "_at_" + std::get<1>(test.param).name;
}

std::vector<std::string> gathering_methods() {
  std::vector<std::string> methods;
  std::copy_if(std::begin(test::every_method), std::end(test::every_method),
               std::back_inserter(methods), [](const std::string& method) {
                 return method.starts_with("fv") || method.starts_with("pointer");
               });
  return methods;
}

INSTANTIATE_TEST_SUITE_P(Everywhere, EverySampler,
                         testing::Combine(testing::ValuesIn(test::every_method),
                                          testing::ValuesIn(places)),
                         name_of_test);
INSTANTIATE_TEST_SUITE_P(Everywhere, GatheringSampler,
                         testing::Combine(testing::ValuesIn(gathering_methods()),
                                          testing::ValuesIn(places)),
                         name_of_test);

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

// Uniform over the display, whatever its lens makes of it.
TEST(ViewportSampler, FollowsItsDensityThroughALens) {
  const Vec3 middle(0.0F, 0.0F, -1.0F);
  const auto vp = make_view_sampler("vp");
  vp->aim({.viewport = Viewport(head_orientation({}), radians(90.0), radians(100.0),
                                {.axis = {0.56F, 0.5F}, .k1 = 0.22F, .k2 = 0.24F})});
  const auto density = [&](const Vec3& d) { return vp->density_per_sr(d); };
  EXPECT_GT(test::chi_squared_p_value(random_directions(*vp), density, middle), 0.01);
  EXPECT_NEAR(test::integral_over_sphere(density, middle), 1.0, 0.005);
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

TEST(PointerSampler, FollowsThePointerOrElseTheGaze) {
  const auto pointer = make_view_sampler("pointer:radius=5");
  Aim aim = aim_at(places[1]);
  const Vec3 elsewhere(1.0F, 0.0F, 0.0F);
  aim.pointer = elsewhere;
  pointer->aim(aim);
  // 1 / (2 pi 5^2) a square degree in the middle, and exp(-2) of it two standard deviations away.
  const double peak = degrees(1.0) * degrees(1.0) / (2.0 * 3.14159265358979 * 25.0);
  EXPECT_NEAR(pointer->density_per_sr(elsewhere) / peak, 1.0, 1e-6);
  const Vec3 ten_degrees_up =
      direction_from({.azimuth_rad = radians(90.0), .elevation_rad = radians(10.0)});
  EXPECT_NEAR(pointer->density_per_sr(ten_degrees_up) / peak,
              std::exp(-2.0) * radians(10.0) / std::sin(radians(10.0)), 1e-5);
  EXPECT_LT(pointer->density_per_sr(aim.gaze), 1e-6);
  aim.pointer.reset();
  pointer->aim(aim);
  EXPECT_NEAR(pointer->density_per_sr(aim.gaze) / peak, 1.0, 1e-6);
}

// Their sum is more than a double holds.
TEST(MixtureSampler, LargeWeightsAreLikeSmallOnes) {
  const Aim aim = aim_at(places[1]);
  const auto large = make_view_sampler("hybrid:1e308*fv+1e308*od");
  const auto small = make_view_sampler("hybrid:1*fv+1*od");
  const auto fv = make_view_sampler("fv");
  const auto od = make_view_sampler("od");
  for (const auto* sampler : {&large, &small, &fv, &od}) {
    (*sampler)->aim(aim);
  }
  EXPECT_DOUBLE_EQ(large->density_per_sr(aim.gaze),
                   0.5 * fv->density_per_sr(aim.gaze) + 0.5 * od->density_per_sr(aim.gaze));
  const std::vector<Vec3> directions = random_directions(*large);
  const std::vector<Vec3> expected = random_directions(*small);
  EXPECT_EQ(directions, expected);
}

// A sample of a mixture could have come from any of its parts.
TEST(MixtureSampler, DensityIsTheWeightedSum) {
  const Aim aim = aim_at(places[1]);
  const auto fv = make_view_sampler("fv");
  const auto od = make_view_sampler("od");
  const auto both = make_view_sampler("hybrid:3*fv+1*od");
  for (const auto* sampler : {&fv, &od, &both}) {
    (*sampler)->aim(aim);
  }
  for (const Vec3& direction : {aim.gaze, Vec3(0, 0, 1), Vec3(1, 0, 0)}) {
    EXPECT_DOUBLE_EQ(both->density_per_sr(direction),
                     0.75 * fv->density_per_sr(direction) + 0.25 * od->density_per_sr(direction));
  }
}

}  // namespace
}  // namespace foveola
