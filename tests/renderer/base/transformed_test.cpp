#include "renderer/base/transformed.h"

#include <array>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foveola {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Named {
  std::string name;
};

TEST(Transformed, AppliesAFunctionInTheOrderOfTheItems) {
  EXPECT_THAT(transformed(std::vector{3, 1, 2}, [](int item) { return 2 * item; }),
              ElementsAre(6, 2, 4));
  EXPECT_THAT(transformed(std::vector<int>(), [](int item) { return item; }), IsEmpty());
}

TEST(Transformed, TakesAMemberOfTheItems) {
  const std::array<Named, 2> items{{{"a"}, {"b"}}};
  const std::vector<std::string> names = transformed(items, &Named::name);
  EXPECT_THAT(names, ElementsAre("a", "b"));
}

TEST(Transformed, ConvertsToAGivenType) {
  const int items[] = {1, 2};
  const std::vector<double> values = transformed<double>(items, [](int item) { return item; });
  EXPECT_THAT(values, ElementsAre(1.0, 2.0));
}

}  // namespace
}  // namespace foveola
