#include "renderer/film/rounded_log2.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/random.h"

namespace foveola {
namespace {

void expect_librarys(const std::vector<double>& numbers) {
  std::vector<float> logs(numbers.size());
  rounded_log2(numbers, logs);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    ASSERT_EQ(logs[i], static_cast<float>(std::log2(numbers[i]))) << numbers[i];
  }
}

TEST(RoundedLog2, IsTheLibrarysRounded) {
  Pcg32 random(3, 5);
  std::vector<double> numbers;
  for (int i = 0; i < 1'000'000; ++i) {
    numbers.push_back(std::exp2(24.0 * random.uniform() - 12.0));
  }
  expect_librarys(numbers);
}

// Around 1 logarithms are small, and floats lie close together.
TEST(RoundedLog2, IsTheLibrarysNextToOne) {
  std::vector<double> numbers;
  for (int exponent = -52; exponent < -1; ++exponent) {
    numbers.push_back(1.0 + std::exp2(exponent));
    numbers.push_back(1.0 - std::exp2(exponent));
  }
  expect_librarys(numbers);
}

// Exact logarithms, ends of the series, and doubles whose logarithms lie in the middle between two
// floats, as near as a double can.
TEST(RoundedLog2, IsTheLibrarysWhereRoundingIsCritical) {
  std::vector<double> numbers = {1e-300, 1e300};
  for (int exponent = -40; exponent <= 40; ++exponent) {
    numbers.push_back(std::exp2(exponent));
    const double root = std::exp2(exponent + 0.5);
    numbers.insert(numbers.end(), {std::nextafter(root, 0.0), root, std::nextafter(root, 1e9)});
  }
  for (float log = 0.5F; log < 4.0F; log += 0.001F) {
    const double middle = 0.5 * (static_cast<double>(log) + std::nextafter(log, 5.0F));
    const double number = std::exp2(middle);
    numbers.insert(numbers.end(),
                   {std::nextafter(number, 0.0), number, std::nextafter(number, 99.0)});
  }
  expect_librarys(numbers);
}

TEST(RoundedLog2, OfNothingIsNothing) { expect_librarys({}); }

}  // namespace
}  // namespace foveola
