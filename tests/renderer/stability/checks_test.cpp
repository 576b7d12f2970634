// The stress tests of `foveola bench stability`, at sizes for every day.
#include "renderer/stability/checks.h"

#include <gtest/gtest.h>

#include "renderer/stability/figure.h"

namespace foveola {
namespace {

constexpr StabilityEffort test_effort{.tolerance = 0.05,
                                      .most_samples = 1 << 20,
                                      .picture_samples_per_pixel = 32,
                                      .leak_paths = 100'000,
                                      .scene_paths = 10'000,
                                      .film_samples = 10'000'000};

const Workers& workers() {
  static const Workers two(2);
  return two;
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

TEST(StabilityCheckTest, KnownAnswers) { expect_all(check_known_answers(small_run())); }

TEST(StabilityCheckTest, ScaleAndPlace) { expect_all(check_scale_and_place(small_run())); }

TEST(StabilityCheckTest, Leaks) { expect_all(check_leaks(small_run())); }

TEST(StabilityCheckTest, DegenerateInput) { expect_all(check_degenerate_input(small_run())); }

TEST(StabilityCheckTest, Accumulation) { expect_all(check_accumulation(small_run())); }

TEST(StabilityCheckTest, BitEquality) { expect_all(check_bit_equality(small_run())); }

}  // namespace
}  // namespace foveola
