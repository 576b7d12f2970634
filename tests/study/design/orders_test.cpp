#include "study/design/orders.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "tests/matchers.h"

namespace foveola::study {
namespace {

// As Williams 1949 and every textbook after it write them.
TEST(WilliamsSquare, OfThreeIsAllSixOrders) {
  EXPECT_THAT(williams_square(3),
              ElementsAre(ElementsAre(0, 1, 2), ElementsAre(1, 2, 0), ElementsAre(2, 0, 1),
                          ElementsAre(2, 1, 0), ElementsAre(0, 2, 1), ElementsAre(1, 0, 2)));
}

TEST(WilliamsSquare, OfFourHasFourRows) {
  EXPECT_THAT(williams_square(4), ElementsAre(ElementsAre(0, 1, 3, 2), ElementsAre(1, 2, 0, 3),
                                              ElementsAre(2, 3, 1, 0), ElementsAre(3, 0, 2, 1)));
}

TEST(CyclicSquare, OfThreeTurns) {
  EXPECT_THAT(cyclic_square(3),
              ElementsAre(ElementsAre(0, 1, 2), ElementsAre(1, 2, 0), ElementsAre(2, 0, 1)));
}

/// How often each pair comes up.
using Pairs = std::map<std::pair<int, int>, int>;

Pairs places_in(const Square& square) {
  Pairs counts;
  for (const Permutation& row : square) {
    for (int position = 0; position < static_cast<int>(row.size()); ++position) {
      ++counts[{row[position], position}];
    }
  }
  return counts;
}

Pairs neighbours_in(const Square& square) {
  Pairs counts;
  for (const Permutation& row : square) {
    for (std::size_t i = 1; i < row.size(); ++i) {
      ++counts[{row[i - 1], row[i]}];
    }
  }
  return counts;
}

/// All `pairs` come up equally often: rows shared out among them.
void expect_even(const Pairs& counts, std::size_t pairs, int often, int n) {
  EXPECT_EQ(counts.size(), pairs) << n;
  for (const auto& [pair, count] : counts) {
    EXPECT_EQ(count, often) << pair.first << ", " << pair.second << " of " << n;
  }
}

class SquaresOfEverySize : public testing::TestWithParam<int> {};

TEST_P(SquaresOfEverySize, ShowEachThingOnceInARowAndEquallyOftenAtAPlace) {
  const int n = GetParam();
  for (const Square& square : {cyclic_square(n), williams_square(n)}) {
    for (const Permutation& row : square) {
      EXPECT_EQ(std::set<int>(row.begin(), row.end()).size(), static_cast<std::size_t>(n));
    }
    expect_even(places_in(square), static_cast<std::size_t>(n * n),
                static_cast<int>(square.size()) / n, n);
  }
}

TEST_P(SquaresOfEverySize, OfWilliamsShowEachThingEquallyOftenAfterEachOther) {
  const int n = GetParam();
  const int rows = n % 2 == 0 || n == 1 ? n : 2 * n;
  EXPECT_EQ(row_count(Order::williams, n), rows);
  expect_even(neighbours_in(williams_square(n)), static_cast<std::size_t>(n * (n - 1)), rows / n,
              n);
}

INSTANTIATE_TEST_SUITE_P(Sizes, SquaresOfEverySize, testing::Range(1, 13));

TEST(RowOf, BeginsAnewAfterTheLast) {
  EXPECT_EQ(row_of(Order::williams, 3, 4), (Permutation{0, 2, 1}));
  EXPECT_EQ(row_of(Order::williams, 3, 604), (Permutation{0, 2, 1}));
  EXPECT_EQ(row_of(Order::fixed, 3, 604), (Permutation{0, 1, 2}));
}

// The starts and renamings that the published study's five scenes and three methods are to have.
TEST(CrossedRow, OfFiveScenesAndThreeMethodsHasItsStartsAndRenamings) {
  constexpr std::array starts{0, 0, 0, 3, 3};
  constexpr std::array renamings{0, 1, 2, 0, 1};
  const Square square = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}, {0, 2, 1}, {1, 0, 2}};
  for (int scene = 0; scene < 5; ++scene) {
    for (int row = 0; row < 20; ++row) {
      Permutation expected = square[(row + starts[scene]) % 6];
      for (int& method : expected) {
        method = (method + renamings[scene]) % 3;
      }
      EXPECT_EQ(crossed_row_of(Order::williams, 3, scene, row), expected) << scene << " " << row;
    }
  }
}

TEST(CrossedRow, OfAFixedOrderIsTheSameEverywhere) {
  EXPECT_EQ(crossed_row_of(Order::fixed, 3, 4, 17), (Permutation{0, 1, 2}));
}

/// The largest count less the smallest, of n x n pairs.
int spread_of(const Pairs& counts, int n) {
  int least = counts.size() < static_cast<std::size_t>(n * n) ? 0 : counts.begin()->second;
  int most = 0;
  for (const auto& [pair, count] : counts) {
    least = std::min(least, count);
    most = std::max(most, count);
  }
  return most - least;
}

TEST(CrossedRow, IsEvenButForOneInEverySceneAfterAnyNumberOfParticipants) {
  for (const Order order : {Order::latin, Order::williams}) {
    for (int methods = 2; methods <= 6; ++methods) {
      for (int scene = 0; scene < 9; ++scene) {
        Square rows;
        for (int row = 0; row < 40; ++row) {
          rows.push_back(crossed_row_of(order, methods, scene, row));
          EXPECT_LE(spread_of(places_in(rows), methods), 1)
              << methods << " methods, scene " << scene << ", row " << row;
        }
      }
    }
  }
}

TEST(CrossedRow, OfThreeMethodsIsEvenButForOneOverAllScenesToo) {
  for (const Order order : {Order::latin, Order::williams}) {
    for (int scenes = 1; scenes <= 9; ++scenes) {
      Square rows;
      for (int row = 0; row < 40; ++row) {
        for (int scene = 0; scene < scenes; ++scene) {
          rows.push_back(crossed_row_of(order, 3, scene, row));
        }
        EXPECT_LE(spread_of(places_in(rows), 3), 1) << scenes << " scenes, row " << row;
      }
    }
  }
}

}  // namespace
}  // namespace foveola::study
