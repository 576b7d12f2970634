#include "analysis/commands/power_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"

namespace foveola::analysis {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

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

TEST(PowerTables, APlansLevelFamilyAndParticipantsAreTaken) {
  study::AnalysisPlan plan;
  plan.alpha = 0.02;
  plan.participants = 12;
  plan.primary = {{"outline", "fv", "od"}, {"comfort", "fv", "vp"}};
  const PowerSettings settings = planned_power({.studies = 500}, plan);
  EXPECT_EQ(settings.family, 2U);
  EXPECT_DOUBLE_EQ(settings.level(), 0.01);
  EXPECT_EQ(settings.participants, 12U);
  EXPECT_EQ(planned_power({.participants = 7}, plan).participants, 7U);
  const PowerPlan of_family = plan_power(settings);
  const PowerPlan of_one = plan_power({.alpha = 0.01, .participants = 12, .studies = 500});
  EXPECT_EQ(of_family.power, of_one.power);
  EXPECT_THAT(power_text(settings, of_family),
              HasSubstr("at a level of 0.01, two-sided (Holm's first of 2 planned comparisons"));
}

}  // namespace
}  // namespace foveola::analysis
