#include "analysis/statistics/power.h"

#include <cmath>

#include "tests/analysis/golden.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

struct Planned {
  int n;
  const char* delta;
};

TEST(Power, IsThatOfR) {
  const auto golden = golden_inference();
  for (const Planned& plan : {Planned{2, "1"}, Planned{16, "0.25"}, Planned{16, "0.8"},
                              Planned{30, "0.5"}, Planned{100, "0.1"}, Planned{5, "3"}}) {
    const std::string name = "power_" + std::to_string(plan.n) + "_" + plan.delta + ".power";
    SCOPED_TRACE(name);
    EXPECT_GOLDEN(paired_t_power(static_cast<std::size_t>(plan.n), {std::stod(plan.delta), 1.0}),
                  golden.at(name));
  }
}

TEST(Power, TheFewestParticipantsAreThoseOfR) {
  const auto golden = golden_inference();
  for (const char* delta : {"0.1", "0.5", "0.8", "2"}) {
    const ExpectedEffect effect{std::stod(delta), 1.0};
    const std::size_t n = participants_for_power(0.9, effect).value();
    EXPECT_EQ(static_cast<double>(n), golden.at(std::string("planning_") + delta + ".n"));
    EXPECT_GE(paired_t_power(n, effect), 0.9);
    EXPECT_LT(paired_t_power(n - 1, effect), 0.9);
  }
}

TEST(Power, WithoutAnEffectItIsTheLevel) {
  EXPECT_NEAR(paired_t_power(16, {0.0, 1.0}), 0.05, 1e-12);
  EXPECT_FALSE(participants_for_power(0.9, {0.0, 1.0}));
}

TEST(Power, TheDirectionAndTheUnitDoNotMatter) {
  EXPECT_DOUBLE_EQ(paired_t_power(12, {-0.6, 1.2}), paired_t_power(12, {0.5, 1.0}));
}

TEST(Power, SimulationAgreesWithTheFormula) {
  const ExpectedEffect effect{0.7, 1.0};
  const SimulatedPower simulated = simulate_power(16, effect, 0.05, 20'000, 3);
  // A fixed seed: four standard errors would miss one seed in sixteen thousand.
  EXPECT_NEAR(simulated.power, paired_t_power(16, effect), 4.0 * std::sqrt(0.25 / 20'000));
  EXPECT_LT(simulated.interval.low, simulated.power);
  EXPECT_GT(simulated.interval.high, simulated.power);
  EXPECT_EQ(simulate_power(16, effect, 0.05, 20'000, 3).power, simulated.power);
}

TEST(Power, AnEffectOnTimesIsARatioAndItsSpread) {
  const ExpectedEffect effect = effect_of_ratio(50.0, 2.0);
  EXPECT_DOUBLE_EQ(effect.mean, -std::log(2.0));
  EXPECT_DOUBLE_EQ(effect.standard_deviation, std::log(2.0));
}

}  // namespace
}  // namespace foveola::analysis
