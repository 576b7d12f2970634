#include "renderer/film/film_state.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "tests/renderer/film/film_samples.h"

namespace foveola {
namespace {

constexpr FilmStatistics keeps_squares = FilmStatistics::mean_and_variance;

TEST(FilmState, IsGoneOnWithAsIfNothingHadBeen) {
  const Workers workers(2);
  EquirectFilm whole(100, 50, keeps_squares);
  add_samples(sobol_samples(0, 3000), whole, workers);
  EquirectFilm restored(100, 50, keeps_squares);
  restored.restore(state_of(whole), workers);
  EXPECT_EQ(film_sha256(restored), film_sha256(whole));
  EXPECT_EQ(restored.total_samples(), whole.total_samples());
  EXPECT_GT(restored.revision(), 0U);

  for (EquirectFilm* const film : {&whole, &restored}) {
    add_samples(sobol_samples(3000, 5000), *film, workers);
  }
  EXPECT_EQ(film_sha256(restored), film_sha256(whole));
  EXPECT_EQ(restored.resolve().variances, whole.resolve().variances);
  for (int level = 0; level < whole.levels(); ++level) {
    for (int y = 0; y < whole.height(level); ++y) {
      for (int x = 0; x < whole.width(level); ++x) {
        ASSERT_EQ(restored.cell(level, x, y).weight, whole.cell(level, x, y).weight);
        ASSERT_EQ(restored.cell(level, x, y).color, whole.cell(level, x, y).color);
      }
    }
  }
}

TEST(FilmState, RemembersNumbersOfSamplesThatWereDropped) {
  const Workers workers(1);
  EquirectFilm film(100, 50);
  NumberedBatch batch;
  film.number(in_pixel(7, 9, film, 2), batch, workers);
  const Rgb infinite(std::numeric_limits<float>::infinity());
  film.add(batch, std::vector<Rgb>{infinite, infinite}, workers);
  EXPECT_EQ(state_of(film).size(), 1U);
  EquirectFilm restored(100, 50);
  restored.restore(state_of(film), workers);
  EXPECT_EQ(restored.sample_count(7, 9), 0U);
  restored.number(in_pixel(7, 9, restored, 1), batch, workers);
  EXPECT_EQ(batch.jobs.front().sample_number, 2U);
}

TEST(PixelSum, IsTheSameInAnyOrder) {
  const std::vector<PixelState> parts = {
      {.pixel = 3, .count = 1, .numbered = 1, .sum = {1e16, 0.1, 1.0}, .squares = 1.0},
      {.pixel = 3, .count = 2, .numbered = 3, .sum = {1.0, 0.2, 1.0}, .squares = 0x1p-53},
      {.pixel = 3, .count = 4, .numbered = 4, .sum = {-1e16, 0.3, 1.0}, .squares = 0x1p-106}};
  PixelSum sum;
  for (const std::vector<int>& order : {std::vector{0, 1, 2}, {2, 1, 0}, {1, 0, 2}}) {
    for (const int part : order) {
      sum.add(parts[static_cast<std::size_t>(part)]);
    }
    const PixelState all = sum.take();
    EXPECT_EQ(all.pixel, 3U);
    EXPECT_EQ(all.count, 7U);
    EXPECT_EQ(all.numbered, 8U);
    EXPECT_EQ(all.sum, DVec3(1.0, 0.6, 3.0));
    EXPECT_EQ(all.squares, 1.0 + 0x1p-52);
  }
}

TEST(PixelSum, CannotHoldMoreSamplesThanAPixel) {
  PixelSum sum;
  sum.add({.count = 1, .numbered = 4'000'000'000U});
  sum.add({.count = 1, .numbered = 4'000'000'000U});
  EXPECT_THROW(sum.take(), Error);
}

}  // namespace
}  // namespace foveola
