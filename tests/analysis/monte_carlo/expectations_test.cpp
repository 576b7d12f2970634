#include "analysis/monte_carlo/expectations.h"

#include <cmath>

#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

study::Protocol planned_protocol(const std::vector<study::PlannedComparison>& comparisons) {
  study::Protocol protocol = example_study().protocol;
  protocol.analysis.primary = comparisons;
  return protocol;
}

void refused(const study::Protocol& protocol, const Expectations& expectations,
             const std::string& message) {
  EXPECT_THAT([&] { (void)expect(protocol, expectations); },
              ThrowsMessage<Error>(HasSubstr(message)));
}

TEST(Expectations, AreReadWithColonsInTheMethod) {
  const MeasureExpectation simple = parse_expectation("material:fv:25");
  EXPECT_EQ(simple.measure, "material");
  EXPECT_EQ(simple.method, "fv");
  EXPECT_EQ(simple.value, 25.0);
  EXPECT_EQ(parse_expectation("comfort:mix:a=1:+0.5").method, "mix:a=1");
  EXPECT_EQ(parse_expectation("comfort:mix:a=1:+0.5").value, 0.5);
  EXPECT_EQ(parse_expectation("comfort:fv:-3").value, -3.0);
  for (const char* text : {"", "material", "material:25", ":fv:25", "material::25", "material:fv:",
                           "material:fv:much", "material:fv:25 %", "material:fv:nan"}) {
    EXPECT_THAT([&] { (void)parse_expectation(text); },
                ThrowsMessage<UsageError>(HasSubstr("MEASURE:METHOD:VALUE")))
        << text;
  }
}

TEST(Expectations, DefaultsAndStatedValues) {
  const study::Protocol protocol =
      planned_protocol({{"outline", "fv", "od"}, {"comfort", "vp", "od"}});
  const ExpectedStudy expected =
      expect(protocol, {.ratio_percent = 40.0,
                        .measures = {{"material", "fv", 30.0}, {"comfort", "vp", -5.0}},
                        .baseline_s = std::vector<double>{7.0},
                        .participants_factor = 1.5,
                        .scenes_factor = 1.0,
                        .withdrawals = 0.2,
                        .scenes = 8});
  EXPECT_EQ(expected.protocol.scenes.size(), 8U);
  EXPECT_EQ(expected.times[0].baseline_s, 7.0);
  EXPECT_EQ(expected.times[2].baseline_s, 28.0);
  EXPECT_EQ(expected.times[0].ratios, (std::vector<double>{1.0, 0.4, 0.4}));
  EXPECT_EQ(expected.times[1].ratios, (std::vector<double>{1.0, 0.4, 0.3}));
  EXPECT_EQ(expected.shifts[1], (std::vector<double>{0.0, -5.0, 0.0}));
  EXPECT_DOUBLE_EQ(expected.times_spread.participants_gain, std::log(1.5));
  EXPECT_EQ(expected.times_spread.scenes_gain, 0.0);
  EXPECT_EQ(expected.withdrawals, 0.2);
}

TEST(Expectations, WhatIsImpossibleIsRefused) {
  const study::Protocol outline = planned_protocol({{"outline", "fv", "od"}});
  refused(outline, {.ratio_percent = 0.0}, "--ratio");
  refused(outline, {.ratio_percent = 100.0}, "no expected difference");
  refused(outline, {.participants_factor = 0.5}, "--spread");
  refused(outline, {.scenes_factor = 0.0}, "--scene-spread");
  refused(outline, {.trials_factor = -1.0}, "--trial-spread");
  refused(outline, {.baseline_s = std::vector<double>{-1.0}}, "--seconds");
  refused(outline, {.baseline_s = std::vector<double>{10.0, 5.0}}, "the previous mark");
  refused(outline, {.baseline_s = std::vector<double>{1.0, 2.0, 3.0, 4.0}}, "4 times for 3 marks");
  refused(outline, {.measures = {{"material", "fv", 20.0}}}, "the previous mark");
  refused(outline, {.measures = {{"outlines", "fv", 20.0}}}, "choose one of outline");
  refused(outline, {.measures = {{"outline", "xy", 20.0}}}, "choose one of od");
  refused(outline, {.measures = {{"outline", "od", 20.0}}}, "this is the baseline");
  refused(outline, {.measures = {{"outline", "fv", -20.0}}}, "above 0");
  refused(planned_protocol({}), {}, "[[analysis.primary]]");
  refused(planned_protocol({{"comfort", "fv", "od"}}), {}, "--effect comfort:fv:1");
  refused(planned_protocol({{"outline", "fv", "vp"}}), {}, "no expected difference");
}

TEST(Expectations, APilotShowsTimesAndSpreadsButNoEffects) {
  ExpectedStudy truth = example_study();
  truth.protocol.analysis.primary = {{"outline", "fv", "od"}};
  truth.times_spread = {.participants = 0.6,
                        .scenes = 0.4,
                        .participants_gain = 0.3,
                        .scenes_gain = 0.2,
                        .trials = 0.25};
  truth.later_marks_variation = 0.6;
  truth.withdrawals = 0.2;
  for (int scene = 6; scene <= 60; ++scene) {
    truth.protocol.scenes.push_back({.name = "scene-" + std::to_string(scene)});
  }
  const study::StudyRecords pilot = draw_study(truth, 75, 3);
  const ExpectedStudy expected = expect(truth.protocol, {.ratio_percent = 90.0}, &pilot);
  EXPECT_EQ(expected.times[0].ratios[2], 0.9);
  const auto near = [](double found, double value, double part) {
    EXPECT_NEAR(found, value, part * value);
  };
  near(expected.times[0].baseline_s, 15.0, 0.4);  // The logarithm's standard error is 0.09.
  near(expected.times_spread.participants, 0.6, 0.35);
  near(expected.times_spread.scenes, 0.4, 0.35);
  near(expected.times_spread.participants_gain, 0.3, 0.3);
  near(expected.times_spread.scenes_gain, 0.2, 0.3);
  near(expected.later_marks_variation, truth.later_marks_variation, 0.1);
  near(expected.ratings_spread.trials, truth.ratings_spread.trials, 0.9);
  EXPECT_GT(expected.withdrawals, 0.05);
  EXPECT_LT(expected.withdrawals, 0.4);
  EXPECT_EQ(expect(truth.protocol, {.ratio_percent = 90.0, .withdrawals = 0.0}, &pilot).withdrawals,
            0.0);
}

TEST(Expectations, APilotWithoutTimesWithTheBaselineAsksForThem) {
  ExpectedStudy truth = example_study();
  truth.protocol.analysis.primary = {{"outline", "fv", "od"}};
  truth.protocol.timing.mark_timeout_s = 1e-3;
  const study::StudyRecords pilot = draw_study(truth, 4, 3);
  EXPECT_THAT([&] { (void)expect(truth.protocol, {}, &pilot); },
              ThrowsMessage<Error>(HasSubstr("--seconds")));
}

}  // namespace
}  // namespace foveola::analysis
