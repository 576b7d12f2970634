#include "study/design/plan.h"

#include <map>
#include <set>

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

Protocol three_by_three() {
  Protocol protocol;
  protocol.scenes = {{.name = "a"}, {.name = "b"}, {.name = "c"}};
  protocol.methods = {"od", "vp", "fv"};
  return protocol;
}

std::string order_of_scenes(const Plan& plan) {
  std::string order;
  for (std::size_t i = 0; i < plan.size(); i += 3) {
    order += plan[i].scene;
  }
  return order;
}

TEST(RandomPlan, ShowsEveryMethodOnceInEveryScene) {
  const Plan plan = random_plan(three_by_three(), 1, 0);
  ASSERT_EQ(plan.size(), 9U);
  std::set<std::pair<std::string, std::string>> cells;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    cells.insert({plan[i].scene, plan[i].method});
    EXPECT_EQ(plan[i].scene_position, static_cast<int>(i / 3));
    EXPECT_EQ(plan[i].method_position, static_cast<int>(i % 3));
    EXPECT_EQ(plan[i].scene, plan[i - i % 3].scene);  // a scene's methods stay together
  }
  EXPECT_EQ(cells.size(), 9U);
}

TEST(RandomPlan, IsAFunctionOfItsSeedAndParticipant) {
  const auto text = [](std::uint64_t seed, int participant) {
    std::string plan;
    for (const PlannedTrial& trial : random_plan(three_by_three(), seed, participant)) {
      plan += trial.scene + trial.method;
    }
    return plan;
  };
  EXPECT_EQ(text(1, 0), text(1, 0));
  std::set<std::string> plans;
  for (int i = 0; i < 20; ++i) {
    plans.insert(text(1, i));
    plans.insert(text(2, i));
  }
  EXPECT_GT(plans.size(), 35U);  // of 1296 plans, 40 draws seldom meet
}

// 6000 participants: every one of the 6 orders of scenes and of methods as often as the others.
TEST(RandomPlan, OrdersAreUniform) {
  std::map<std::string, int> scenes;
  std::map<std::string, int> methods;
  for (int participant = 0; participant < 6000; ++participant) {
    const Plan plan = random_plan(three_by_three(), 7, participant);
    ++scenes[order_of_scenes(plan)];
    ++methods[plan[3].method + plan[4].method + plan[5].method];
  }
  for (const auto& counts : {scenes, methods}) {
    ASSERT_EQ(counts.size(), 6U);
    double chi_squared = 0.0;
    for (const auto& [order, count] : counts) {
      chi_squared += (count - 1000.0) * (count - 1000.0) / 1000.0;
    }
    EXPECT_LT(chi_squared, 20.5);  // the 99.9 % quantile with 5 degrees of freedom
  }
}

}  // namespace
}  // namespace foveola::study
