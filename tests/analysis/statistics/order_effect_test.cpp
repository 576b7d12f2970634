#include "analysis/statistics/models/order_balance.h"
#include "tests/analysis/golden.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

std::vector<OrderedValue> golden_order() {
  const GoldenMatrix rows = golden_matrices().at("order");
  std::vector<OrderedValue> values;
  for (const auto& row : rows) {
    values.push_back(
        {static_cast<std::size_t>(*row[0]), static_cast<std::size_t>(*row[1]), *row[2], *row[3]});
  }
  return values;
}

TEST(OrderEffect, IsThatOfR) {
  const auto golden = golden_inference();
  const TTest test = order_effect(golden_order()).value();
  EXPECT_EQ(test.n, 8U);
  EXPECT_GOLDEN(test.mean, golden.at("order.mean"));
  EXPECT_GOLDEN(test.t, golden.at("order.t"));
  EXPECT_GOLDEN(test.p, golden.at("order.p"));
}

TEST(OrderEffect, ConditionsAndPeopleAreNotTakenForIt) {
  std::vector<OrderedValue> values = golden_order();
  const double plain = order_effect(values)->mean;
  for (OrderedValue& value : values) {
    value.value +=
        3.0 * static_cast<double>(value.condition) - 2.0 * static_cast<double>(value.participant);
  }
  EXPECT_NEAR(order_effect(values)->mean, plain, 1e-13);
  for (OrderedValue& value : values) {
    value.value += 0.25 * value.position;
  }
  EXPECT_NEAR(order_effect(values)->mean, plain + 0.25, 1e-13);
}

TEST(OrderEffect, WithoutVaryingPositionsThereIsNone) {
  std::vector<OrderedValue> values = golden_order();
  for (OrderedValue& value : values) {
    value.position = 2.0;
  }
  EXPECT_FALSE(order_effect(values));
  EXPECT_FALSE(order_effect({}));
}

// Two centred slopes are equal by construction: P was 3e-15, by rounding alone.
TEST(OrderEffect, TwoParticipantsHaveNone) {
  std::vector<OrderedValue> values = golden_order();
  std::erase_if(values, [](const OrderedValue& value) { return value.participant > 2; });
  EXPECT_FALSE(values.empty());
  EXPECT_FALSE(order_effect(values));
}

TEST(OrderEffect, AFixedOrderIsConfoundedWithConditionsAndHasNone) {
  std::vector<OrderedValue> values = golden_order();
  for (OrderedValue& value : values) {
    value.position = static_cast<double>(value.condition);
  }
  EXPECT_FALSE(order_effect(values));
}

}  // namespace
}  // namespace foveola::analysis
