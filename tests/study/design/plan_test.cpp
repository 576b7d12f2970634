#include "study/design/plan.h"

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "tests/matchers.h"
#include "tests/study/design/small_protocol.h"

namespace foveola::study {
namespace {

Protocol three_by_three() { return test::small_protocol(3, 3, Order::random, Order::random); }

/// "ax ay az! ...": scenes and methods, catch trials with an exclamation mark.
std::string text_of(const Plan& plan) {
  std::string text;
  for (const PlannedTrial& trial : plan) {
    text += (text.empty() ? "" : " ") + trial.scene + trial.method +
            (trial.kind == TrialKind::catch_trial ? "!" : "");
  }
  return text;
}

std::string order_of_scenes(const Plan& plan) {
  std::string order;
  for (std::size_t i = 0; i < plan.size(); i += 3) {
    order += plan[i].scene;
  }
  return order;
}

TEST(RandomPlan, ShowsEveryMethodOnceInEveryScene) {
  const Plan plan = make_plan(three_by_three(), 1, 0);
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
    return text_of(make_plan(three_by_three(), seed, participant));
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
    const Plan plan = make_plan(three_by_three(), 7, participant);
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

Order order_called(const std::string& name) {
  for (const Order order : {Order::fixed, Order::random, Order::latin, Order::williams}) {
    if (name_of(order) == name) {
      return order;
    }
  }
  throw std::invalid_argument(name);
}

std::vector<std::string> cells_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(stream, cell, ',');) {
    cells.push_back(cell);
  }
  return cells;
}

// The plans are golden_plans.py's, beside this file, whatever the compiler and the platform.
TEST(MakePlan, IsWhatAnotherProgramMakesOfTheSameSeeds) {
  std::ifstream file(TEST_DATA_DIR "/golden_plans.csv");
  std::string line;
  std::getline(file, line);
  ASSERT_EQ(line, "scene_order,method_order,catch_trials,seed,row,plan");
  int plans = 0;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = cells_of(line);
    ASSERT_EQ(cells.size(), 6U) << line;
    Protocol protocol = test::small_protocol(5, 3, order_called(cells[0]), order_called(cells[1]));
    protocol.catch_trials.count = std::stoi(cells[2]);
    EXPECT_EQ(text_of(make_plan(protocol, std::stoull(cells[3]), std::stoi(cells[4]))), cells[5])
        << line;
    ++plans;
  }
  EXPECT_EQ(plans, 64);
}

TEST(MakePlan, BeginsWithThePracticeInItsOrder) {
  Protocol protocol = three_by_three();
  protocol.practice = {{.scene = "c", .method = "z"}, {.scene = "a", .method = "x"}};
  const Plan plan = make_plan(protocol, 1, 0);
  ASSERT_EQ(plan.size(), 11U);
  EXPECT_EQ(plan[0].kind, TrialKind::practice);
  EXPECT_EQ(plan[0].scene + plan[0].method, "cz");
  EXPECT_EQ(plan[1].kind, TrialKind::practice);
  EXPECT_EQ(plan[1].scene + plan[1].method, "ax");
  EXPECT_EQ(text_of(Plan(plan.begin() + 2, plan.end())),
            text_of(make_plan(three_by_three(), 1, 0)));
}

// 9 places for 3 catch trials, in 3000 plans: each about 1000 times (standard deviation 26).
TEST(MakePlan, CatchTrialsComeAnywhereButFirstAndNeverTwoInARow) {
  Protocol protocol = three_by_three();
  protocol.catch_trials.count = 3;
  std::map<std::size_t, int> tests_before;
  for (int row = 0; row < 3000; ++row) {
    const Plan plan = make_plan(protocol, 5, row);
    ASSERT_EQ(plan.size(), 12U);
    std::size_t tests = 0;
    for (std::size_t i = 0; i < plan.size(); ++i) {
      if (plan[i].kind == TrialKind::test) {
        ++tests;
        continue;
      }
      ASSERT_GT(i, 0U);
      EXPECT_EQ(plan[i - 1].kind, TrialKind::test);
      EXPECT_EQ(plan[i].scene + plan[i].method, plan[i - 1].scene + plan[i - 1].method);
      ++tests_before[tests];
    }
  }
  ASSERT_EQ(tests_before.size(), 9U);
  for (const auto& [tests, count] : tests_before) {
    EXPECT_NEAR(count, 1000, 4 * 26) << "after " << tests;
  }
}

TEST(DesignRows, AreTheSquaresTogether) {
  const auto rows = [](Order scenes, Order methods) {
    return design_rows(test::small_protocol(5, 3, scenes, methods));
  };
  EXPECT_EQ(rows(Order::random, Order::random), 0);
  EXPECT_EQ(rows(Order::random, Order::williams), 6);
  EXPECT_EQ(rows(Order::williams, Order::random), 10);
  EXPECT_EQ(rows(Order::williams, Order::williams), 30);
  EXPECT_EQ(rows(Order::latin, Order::latin), 15);
  EXPECT_EQ(rows(Order::fixed, Order::latin), 3);
  EXPECT_EQ(rows(Order::fixed, Order::fixed), 1);
}

TEST(LeastUsedRow, IsTheNextOneWhoeverLeft) {
  const Protocol six = test::small_protocol(5, 3, Order::fixed, Order::williams);
  EXPECT_EQ(least_used_row(six, {}), 0);
  EXPECT_EQ(least_used_row(six, {0, 1, 2}), 3);
  EXPECT_EQ(least_used_row(six, {2, 0, 3}), 1) << "who had row 1 withdrew";
  EXPECT_EQ(least_used_row(six, {5, 4, 3, 2, 1, 0}), 6) << "row 0 of the design again";
  EXPECT_EQ(least_used_row(six, {0, 1, 2, 3, 4, 5, 6, 8}), 7);
  EXPECT_EQ(least_used_row(six, {0, 6, 2, 3, 4, 5}), 1) << "row 0 was used twice";
  EXPECT_EQ(least_used_row(six, {}, 4), 4) << "another site";
  EXPECT_EQ(least_used_row(six, {4, 5}, 4), 0);
  EXPECT_EQ(least_used_row(six, {4, 5, 0, 1, 2, 3}, 4), 10);
}

TEST(LeastUsedRow, OfDrawnOrdersIsOneThatNobodyHas) {
  EXPECT_EQ(least_used_row(three_by_three(), {}), 0);
  EXPECT_EQ(least_used_row(three_by_three(), {0, 1, 3}), 2);
}

TEST(Kinds, HaveTheNamesOfTheRecord) {
  EXPECT_STREQ(name_of(TrialKind::test), "test");
  EXPECT_STREQ(name_of(TrialKind::practice), "practice");
  EXPECT_STREQ(name_of(TrialKind::catch_trial), "catch");
}

}  // namespace
}  // namespace foveola::study
