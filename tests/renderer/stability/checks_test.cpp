// The stress tests of `foveola bench stability`, at sizes for every day.
#include "renderer/stability/checks.h"

#include <cmath>

#include "renderer/stability/furnished_room.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

constexpr StabilityEffort test_effort{.tolerance = 0.05,
                                      .max_samples = 1 << 20,
                                      .picture_width = 32,
                                      .picture_samples_per_pixel = 32,
                                      .leak_paths = 30'000,
                                      .scene_paths = 10'000,
                                      .film_samples = 10'000'000};

const Workers& workers() {
  static const Workers four(4);
  return four;
}

StabilityRun small_run() { return {.workers = workers(), .effort = test_effort}; }

void expect_all(const std::vector<StabilityFigure>& figures) {
  EXPECT_FALSE(figures.empty());
  for (const StabilityFigure& figure : figures) {
    EXPECT_TRUE(figure.passes()) << figure.name << ": " << figure.measured << " " << figure.unit
                                 << ", at most " << figure.bound << "; " << figure.details;
  }
}

TEST(StabilityCheckTest, WhiteFurnaces) { expect_all(check_white_furnaces(small_run())); }

TEST(StabilityCheckTest, MixedLayers) { expect_all(check_mixed_layers(small_run())); }

TEST(StabilityCheckTest, KnownAnswers) { expect_all(check_known_answers(small_run())); }

TEST(StabilityCheckTest, ScaleAndPlace) { expect_all(check_scale_and_place(small_run())); }

TEST(StabilityCheckTest, Leaks) { expect_all(check_leaks(small_run())); }

TEST(StabilityCheckTest, DegenerateInput) { expect_all(check_degenerate_input(small_run())); }

TEST(StabilityCheckTest, Accumulation) { expect_all(check_accumulation(small_run())); }

TEST(StabilityCheckTest, BitEquality) { expect_all(check_bit_equality(small_run())); }

TEST(StabilityFigureTest, NotANumberDoesNotPass) {
  EXPECT_TRUE((StabilityFigure{.measured = 1.0, .bound = 1.0}).passes());
  EXPECT_FALSE((StabilityFigure{.measured = 1.1, .bound = 1.0}).passes());
  EXPECT_FALSE((StabilityFigure{.measured = std::nan(""), .bound = 1.0}).passes());
}

class FiniteRadianceTest : public ::testing::Test {
 protected:
  FiniteRadianceTest() {
    source_.name = "room";
    source_.file = folder_.write("room.glb", glb_of(furnished_room(), room_viewpoint, DVec3(0.0)));
    source_.camera_position = room_viewpoint;
  }

  test::TemporaryFolder folder_;
  SceneSource source_;
};

TEST_F(FiniteRadianceTest, PassesInARoom) {
  const auto figures = check_finite_radiance(small_run(), {source_});
  expect_all(figures);
  EXPECT_EQ(figures.front().unit, "of 9999 paths");
}

/// A sky so bright that no float holds it.
TEST_F(FiniteRadianceTest, NamesTheFirstPathThatOverflows) {
  source_.camera_position = Vec3(0, 2, 0);
  // One of twenty is sampled, for all of them.
  source_.suns.assign(20, {.place = {.elevation_rad = 1.0}, .irradiance = Rgb(3e38F)});
  const auto figures = check_finite_radiance(small_run(), {source_});
  EXPECT_GT(figures.front().measured, 10.0);
  EXPECT_FALSE(figures.front().passes());
  EXPECT_THAT(figures.front().details,
              AllOf(HasSubstr("room with od, pixel "), HasSubstr(", seed 1: ")));
}

}  // namespace
}  // namespace foveola
