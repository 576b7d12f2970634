#include <nlohmann/json.hpp>

#include "analysis/commands/power_command.h"
#include "renderer/base/error.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(PowerTables, FewestParticipantsReachTheTarget) {
  const PowerSettings settings{.ratio_percent = 70.0, .spread = 1.8, .studies = 2000};
  const PowerPlan plan = plan_power(settings);
  EXPECT_GE(plan.power, 0.9);
  PowerSettings fewer = settings;
  fewer.participants = plan.participants - 1;
  EXPECT_LT(plan_power(fewer).power, 0.9);
  EXPECT_THAT(power_text(settings, plan), HasSubstr(std::to_string(plan.participants)));
  const nlohmann::json json = nlohmann::json::parse(power_json(settings, plan));
  EXPECT_EQ(json["participants"], plan.participants);
  EXPECT_LE(json["simulated_ci95"][0].get<double>(), json["simulated_power"].get<double>());
}

TEST(PowerTables, WhatIsNoEffectOrNoSpreadIsRefused) {
  EXPECT_THAT([] { (void)plan_power({.ratio_percent = 100.0}); },
              ThrowsMessage<Error>(HasSubstr("--ratio")));
  EXPECT_THAT([] { (void)plan_power({.ratio_percent = -3.0}); },
              ThrowsMessage<Error>(HasSubstr("--ratio")));
  EXPECT_THAT([] { (void)plan_power({.spread = 1.0}); },
              ThrowsMessage<Error>(HasSubstr("--spread")));
  EXPECT_THAT([] { (void)plan_power({.ratio_percent = 99.9999, .spread = 50.0}); },
              ThrowsMessage<Error>(HasSubstr("too few")));
}

}  // namespace
}  // namespace foveola::analysis
