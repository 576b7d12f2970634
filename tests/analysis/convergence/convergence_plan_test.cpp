#include "analysis/convergence/convergence_plan.h"

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(SplitMethods, KnowsSettingsFromMethods) {
  EXPECT_THAT(split_methods("od,vp,fv"), ElementsAre("od", "vp", "fv"));
  EXPECT_THAT(split_methods("od,fv:acuity=guenter,cutoff=60,hybrid:0.9*fv:cutoff=60,exponent=2+0.1*"
                            "od,vp"),
              ElementsAre("od", "fv:acuity=guenter,cutoff=60",
                          "hybrid:0.9*fv:cutoff=60,exponent=2+0.1*od", "vp"));
  EXPECT_THAT(split_methods("mask:file=\"a,b.png\",od"),
              ElementsAre("mask:file=\"a,b.png\"", "od"));
}

TEST(Configurations, AreTheMethodsAndTheBaselineWithEachOption) {
  const std::vector<Configuration> configurations =
      make_configurations({"od", "fv"}, {"independent"});
  ASSERT_EQ(configurations.size(), 3U);
  EXPECT_EQ(configurations[1].name, "fv");
  EXPECT_EQ(configurations[1].render.numbers, RandomNumbers::low_discrepancy);
  EXPECT_EQ(configurations[2].name, "od, independent numbers");
  EXPECT_EQ(configurations[2].method, "od");
  EXPECT_EQ(configurations[2].render.numbers, RandomNumbers::independent);
}

TEST(Configurations, ChangeOneThingEach) {
  const std::vector<Configuration> configurations = make_configurations(
      {"od"}, {"clamp", "adaptive", "no-fast-path", "no-hierarchy", "no-learning"});
  ASSERT_EQ(configurations.size(), 6U);
  EXPECT_FALSE(configurations[0].render.adaptive);
  EXPECT_EQ(configurations[1].render.trace.largest_radiance, 10.0F);
  EXPECT_FALSE(configurations[1].render.adaptive);
  EXPECT_GT(configurations[2].render.trace.largest_radiance, 1e30F);
  EXPECT_EQ(configurations[2].render.adaptive.value().contrast, 0.01);
  EXPECT_FALSE(configurations[2].render.trace.uses_general_path);
  EXPECT_TRUE(configurations[3].render.trace.uses_general_path);
  EXPECT_EQ(configurations[3].light_sampling, LightSampling{});
  EXPECT_EQ(configurations[4].light_sampling.selection, LightSelection::by_power_alone);
  EXPECT_TRUE(configurations[4].light_sampling.learns);
  EXPECT_FALSE(configurations[5].light_sampling.learns);
}

TEST(Configurations, OfPlainPathsAreTheirPartsTogether) {
  const std::vector<Configuration> configurations = make_configurations(
      {"od"}, {"independent", "uniform-lights", "area-lights", "cosine-sky", "no-mis",
               "no-roulette", "plain-paths", "plain-paths-mis", "plain-paths-mis-clamp"});
  ASSERT_EQ(configurations.size(), 10U);
  for (std::size_t i = 0; i < configurations.size(); ++i) {
    const Configuration& configuration = configurations[i];
    const bool is_plain = i >= 7;
    EXPECT_EQ(configuration.render.numbers == RandomNumbers::independent, i == 1 || is_plain);
    EXPECT_EQ(configuration.light_sampling.selection == LightSelection::uniform,
              i == 2 || is_plain);
    EXPECT_EQ(configuration.light_sampling.triangles_by_area, i == 3 || is_plain);
    EXPECT_EQ(configuration.light_sampling.environment_by_cosine, i == 4 || is_plain);
    EXPECT_EQ(configuration.render.trace.light_samples_alone, i == 5 || i == 7);
    EXPECT_EQ(configuration.render.trace.vertices_before_roulette == no_roulette,
              i == 6 || is_plain);
    EXPECT_EQ(configuration.render.trace.largest_light_sample == 3.0F, i == 9);
  }
}

TEST(Configurations, RefuseWhatMakesNoSense) {
  EXPECT_THAT([] { (void)make_configurations({"od", "dov"}, {}); },
              ThrowsMessage<Error>(HasSubstr("dov")));
  EXPECT_THAT([] { (void)make_configurations({"od"}, {"no-magic"}); },
              ThrowsMessage<UsageError>(
                  HasSubstr("'no-magic' is not an option; choose from: independent")));
  EXPECT_THAT([] { (void)make_configurations({"od", "fv", "od"}, {}); },
              ThrowsMessage<UsageError>(HasSubstr("'od' is repeated")));
  EXPECT_THROW((void)make_configurations({}, {}), UsageError);
}

TEST(Checkpoints, DoubleUpToTheLastSample) {
  ConvergencePlan plan;
  plan.size = {64, 32};
  plan.samples_per_pixel = 16;
  const std::vector<std::uint64_t> counts = checkpoints(plan);
  ASSERT_EQ(counts.size(), 9U);
  EXPECT_EQ(counts.front(), 128U);
  EXPECT_EQ(counts.back(), 32768U);
  for (std::size_t i = 1; i < counts.size(); ++i) {
    EXPECT_EQ(counts[i], 2 * counts[i - 1]);
  }
}

TEST(Checkpoints, AreNeverWithoutSamples) {
  ConvergencePlan plan;
  plan.size = {4, 2};
  plan.samples_per_pixel = 16;
  EXPECT_THAT(checkpoints(plan), ElementsAre(1, 2, 4, 8, 16, 32, 64, 128));
}

TEST(GazeName, IsInDegrees) {
  EXPECT_EQ(gaze_name({.azimuth_rad = radians(78.0), .elevation_rad = radians(-12.5)}), "78,-12.5");
  EXPECT_EQ(gaze_name({.azimuth_rad = -1e-9}), "0,0");
}

}  // namespace
}  // namespace foveola::analysis
