#include "renderer/view/viewport.h"

#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/base/numbers/random.h"
#include "renderer/view/view_sampler.h"
#include "tests/renderer/view/chi_squared.h"

namespace foveola {
namespace {

// The two middle columns of eight, and of the lower row the one to their right as well.
const std::vector<std::string> few_cells = {"18", "1c"};

TEST(SeenPart, ContainsItsCells) {
  const SeenPart seen(few_cells);
  EXPECT_EQ(seen.rows(), few_cells);
  EXPECT_DOUBLE_EQ(seen.share(), 5.0 / 16.0);
  EXPECT_TRUE(seen.contains({3.5F / 8.0F, 0.25F}));
  EXPECT_FALSE(seen.contains({2.5F / 8.0F, 0.25F}));
  EXPECT_FALSE(seen.contains({5.5F / 8.0F, 0.25F}));
  EXPECT_TRUE(seen.contains({5.5F / 8.0F, 0.75F}));
  EXPECT_FALSE(seen.contains({1.0F, 1.0F}));
}

TEST(SeenPart, PlacesPointsEvenlyOverItsCellsAndNowhereElse) {
  const SeenPart seen(few_cells);
  Pcg32 random(3);
  std::vector<int> counts(16, 0);
  constexpr int points = 160'000;
  for (int i = 0; i < points; ++i) {
    const float x = unit_float(random.next());
    const Vec2 place = seen.place({x, unit_float(random.next())});
    ASSERT_TRUE(seen.contains(place));
    ++counts[static_cast<std::size_t>(8 * static_cast<int>(2.0F * place.y) +
                                      static_cast<int>(8.0F * place.x))];
  }
  for (const int cell : {3, 4, 11, 12, 13}) {
    EXPECT_NEAR(counts[static_cast<std::size_t>(cell)], points / 5, 700) << cell;
  }
}

TEST(SeenPart, NeighboursStayNeighboursAndEndsAreInside) {
  const SeenPart seen(few_cells);
  EXPECT_EQ(seen.place({0.0F, 0.0F}), Vec2(3.0F / 8.0F, 0.0F));
  for (const float end : {0.0F, 0x1.fffffep-1F}) {
    for (const float other : {0.0F, 0x1.fffffep-1F}) {
      EXPECT_TRUE(seen.contains(seen.place({end, other})));
    }
  }
}

TEST(SeenPart, SaysWhatIsNone) {
  for (const std::vector<std::string>& rows : {std::vector<std::string>{},
                                               {""},
                                               {"1", "11"},
                                               {"1", "g"},
                                               {"00", "00"},
                                               {std::string(300, 'f')},
                                               std::vector<std::string>(2000, "f")}) {
    EXPECT_THROW(SeenPart{rows}, Error);
  }
}

TEST(ViewportSampler, SamplesNothingThatIsNeverSeen) {
  const auto seen = std::make_shared<const SeenPart>(few_cells);
  const AzimuthElevation heading{.azimuth_rad = 1.0, .elevation_rad = 0.3};
  const Aim aim{.viewport = Viewport(head_orientation(heading), radians(100.0), radians(80.0)),
                .gaze = direction_from(heading),
                .pointer = {},
                .seen = seen};
  const auto vp = make_view_sampler("vp");
  vp->aim(aim);
  Pcg32 random(5);
  std::vector<Vec2> points(100'000);
  for (Vec2& point : points) {
    const float x = unit_float(random.next());
    point = {x, unit_float(random.next())};
  }
  std::vector<ViewSample> samples(points.size());
  vp->sample(points, samples);
  std::vector<Vec3> directions;
  for (const ViewSample& sample : samples) {
    directions.push_back(sample.direction);
    ASSERT_TRUE(seen->contains(aim.viewport.project(sample.direction).value()));
  }
  const auto density = [&](const Vec3& direction) { return vp->density_per_sr(direction); };
  EXPECT_NEAR(test::integral_over_sphere(density, aim.gaze), 1.0, 0.01);
  EXPECT_GT(test::chi_squared_p_value(directions, density, aim.gaze), 1e-4);
}

}  // namespace
}  // namespace foveola
