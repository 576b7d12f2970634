#include "study/design/balance.h"

#include "tests/matchers.h"
#include "tests/study/design/small_protocol.h"

namespace foveola::study {
namespace {

Balance balance_after(const Protocol& protocol, int participants) {
  std::vector<Plan> plans;
  for (int row = 0; row < participants; ++row) {
    plans.push_back(make_plan(protocol, 1, row));
  }
  return balance_of(protocol, plans);
}

TEST(Balance, CountsPlacesAndNeighbours) {
  const Protocol protocol = test::small_protocol(2, 2, Order::fixed, Order::fixed);
  const auto test = [](const char* scene, const char* method, int scene_position,
                       int method_position) {
    return PlannedTrial{.scene = scene,
                        .method = method,
                        .scene_position = scene_position,
                        .method_position = method_position};
  };
  const PlannedTrial practice{.scene = "b", .method = "y", .kind = TrialKind::practice};
  const PlannedTrial catch_trial{.scene = "a", .method = "x", .kind = TrialKind::catch_trial};
  const Balance balance = balance_of(
      protocol,
      {{practice, test("a", "x", 0, 0), catch_trial, test("a", "y", 0, 1), test("b", "y", 1, 0),
        test("b", "x", 1, 1)},
       {test("a", "x", 0, 0), test("a", "y", 0, 1), test("b", "x", 1, 0), test("b", "y", 1, 1)}});
  EXPECT_THAT(balance.method_at, ElementsAre(ElementsAre(3, 1), ElementsAre(1, 3)));
  EXPECT_THAT(balance.method_at_in[0], ElementsAre(ElementsAre(2, 0), ElementsAre(0, 2)));
  EXPECT_THAT(balance.method_at_in[1], ElementsAre(ElementsAre(1, 1), ElementsAre(1, 1)));
  EXPECT_THAT(balance.method_after, ElementsAre(ElementsAre(0, 1), ElementsAre(3, 0)));
  EXPECT_THAT(balance.scene_at, ElementsAre(ElementsAre(2, 0), ElementsAre(0, 2)));
  EXPECT_THAT(balance.scene_after, ElementsAre(ElementsAre(0, 0), ElementsAre(2, 0)));
  EXPECT_EQ(largest_difference(balance.method_at), 2);
  EXPECT_EQ(largest_difference_after(balance.method_after), 2);
}

// The published study's size: exactly balanced for 12 and 18 participants, and for its 16 but for
// one at each position.
TEST(Balance, OfWilliamsForFiveScenesAndThreeMethods) {
  const Protocol protocol = test::small_protocol(5, 3, Order::williams, Order::williams);
  for (const int participants : {12, 18}) {
    const Balance balance = balance_after(protocol, participants);
    EXPECT_THAT(balance.method_at, Each(Each(5 * participants / 3)));
    EXPECT_THAT(balance.method_at_in, Each(Each(Each(participants / 3))));
    EXPECT_EQ(largest_difference_after(balance.method_after), 0);
    EXPECT_LE(largest_difference(balance.scene_at), 1);
  }
  const Balance sixteen = balance_after(protocol, 16);
  EXPECT_EQ(largest_difference(sixteen.method_at), 1);
  for (const Counts& counts : sixteen.method_at_in) {
    EXPECT_EQ(largest_difference(counts), 1);
  }
  EXPECT_LE(largest_difference(sixteen.scene_at), 1);
}

TEST(Balance, OfWilliamsScenesIsExactAfterAllTheirRows) {
  const Protocol protocol = test::small_protocol(5, 3, Order::williams, Order::random);
  const Balance balance = balance_after(protocol, 20);
  EXPECT_THAT(balance.scene_at, Each(Each(4)));
  EXPECT_EQ(largest_difference_after(balance.scene_after), 0);
}

TEST(Balance, OfNobodyIsNothing) {
  const Protocol protocol = test::small_protocol(1, 1, Order::williams, Order::williams);
  const Balance balance = balance_of(protocol, {});
  EXPECT_EQ(largest_difference(balance.method_at), 0);
  EXPECT_EQ(largest_difference_after(balance.method_after), 0);
}

}  // namespace
}  // namespace foveola::study
