#include "renderer/film/equirect_film.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/view/equirect.h"
#include "tests/renderer/film/film_samples.h"

namespace foveola {
namespace {

TEST(EquirectFilm, NumbersEachPixelsSamplesInOrder) {
  const Workers workers(2);
  EquirectFilm film(100, 50);  // neither side a multiple of the tile's
  NumberedBatch batch;
  std::map<std::uint32_t, std::uint32_t> next;
  for (const std::uint64_t begin : {0U, 5000U, 12000U}) {
    const std::vector<ViewSample> samples = sobol_samples(begin, 5000);
    film.number(samples, batch, workers);
    ASSERT_EQ(batch.jobs.size(), samples.size());
    for (const SampleJob& job : batch.jobs) {
      const Vec2 image = equirect_from_direction(job.direction);
      EXPECT_EQ(job.sample_number, next[job.pixel]++);
      const std::uint32_t column = job.pixel % 100;
      const std::uint32_t row = job.pixel / 100;
      EXPECT_NEAR(static_cast<float>(column) + 0.5F, image.x * 100.0F, 0.5001F);
      EXPECT_NEAR(static_cast<float>(row) + 0.5F, image.y * 50.0F, 0.5001F);
    }
  }
}

TEST(EquirectFilm, TilesPartitionTheBatch) {
  const Workers workers(2);
  EquirectFilm film(100, 50);
  NumberedBatch batch;
  film.number(sobol_samples(0, 3000), batch, workers);
  std::size_t end = 0;
  for (const NumberedBatch::TileRange& range : batch.tiles) {
    EXPECT_EQ(range.begin, end);
    EXPECT_LT(range.begin, range.end);
    end = range.end;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const std::uint32_t tile =
          batch.jobs[i].pixel / 100 / 32 * 4 + batch.jobs[i].pixel % 100 / 32;
      EXPECT_EQ(tile, range.tile);
    }
  }
  EXPECT_EQ(end, batch.jobs.size());
}

// Paths that are traced together then share more of what is in the cache.
TEST(EquirectFilm, NeighboursInABatchLieCloseToEachOtherInBothDirections) {
  const Workers workers(2);
  EquirectFilm film(4096, 2048);
  NumberedBatch batch;
  film.number(sobol_samples(0, 1 << 15), batch, workers);
  constexpr std::size_t block = 512;
  for (std::size_t begin = 0; begin < batch.jobs.size(); begin += block) {
    IVec2 first(4096, 2048);
    IVec2 last(0);
    for (std::size_t i = begin; i < begin + block; ++i) {
      const IVec2 pixel(batch.jobs[i].pixel % 4096, batch.jobs[i].pixel / 4096);
      first = glm::min(first, pixel);
      last = glm::max(last, pixel);
    }
    EXPECT_LE(last.x - first.x, 1024) << "where rows of the film would have 4096";
    EXPECT_LE(last.y - first.y, 512);
  }
}

TEST(EquirectFilm, APixelIsTheMeanOfItsSamples) {
  const Workers workers(2);
  EquirectFilm film(64, 32);
  NumberedBatch batch;
  film.number(in_pixel(63, 31, film, 3), batch, workers);
  film.add(batch, std::vector<Rgb>{{1, 2, 3}, {2, 4, 6}, {6, 0, 0}}, workers);
  EXPECT_EQ(film.mean(63, 31), Rgb(3, 2, 3));
  EXPECT_EQ(film.sample_count(63, 31), 3U);
  EXPECT_EQ(film.total_samples(), 3U);
  EXPECT_EQ(film.mean(0, 0), Rgb(0.0F));
  EXPECT_EQ(film.sample_count(0, 0), 0U);
  const FilmImage image = film.resolve();
  EXPECT_EQ(image.color.at(63, 31), Rgb(3, 2, 3));
  EXPECT_EQ(image.samples.back(), 3U);
}

TEST(EquirectFilm, NonFiniteSamplesAreDroppedCountedAndNamed) {
  const Workers workers(2);
  EquirectFilm film(64, 32);
  NumberedBatch batch;
  film.number(in_pixel(5, 7, film, 4), batch, workers);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<DroppedSample> dropped = film.add(
      batch, std::vector<Rgb>{{1, 1, 1}, {0, nan, 0}, {3, 3, 3}, {-infinity, 0, 0}}, workers);
  ASSERT_EQ(dropped.size(), 2U);
  EXPECT_EQ(dropped[0].pixel, 7U * 64 + 5);
  EXPECT_EQ(dropped[0].sample_number, 1U);
  EXPECT_EQ(dropped[1].sample_number, 3U);
  EXPECT_EQ(film.mean(5, 7), Rgb(2.0F));
  EXPECT_EQ(film.sample_count(5, 7), 2U);
  EXPECT_EQ(film.total_samples(), 2U);
  film.number(in_pixel(5, 7, film, 1), batch, workers);
  EXPECT_EQ(batch.jobs[0].sample_number, 4U);  // dropped samples keep their numbers
}

// A float sum would stall at 2^24 here.
TEST(EquirectFilm, SumsOfTensOfMillionsOfSamplesStayExact) {
  const Workers workers(2);
  EquirectFilm film(1, 1);
  NumberedBatch batch;
  const std::vector<ViewSample> samples = in_pixel(0, 0, film, 1'000'000);
  const std::vector<Rgb> colors(samples.size(), Rgb(0.1F, 1.0F, 1000.0F));
  for (int i = 0; i < 20; ++i) {
    film.number(samples, batch, workers);
    film.add(batch, colors, workers);
  }
  EXPECT_EQ(film.sample_count(0, 0), 20'000'000U);
  EXPECT_EQ(film.mean(0, 0), Rgb(0.1F, 1.0F, 1000.0F));
}

/// A cell of the pyramid by its definition.
PremultipliedTexel average_of_pixels(const EquirectFilm& film, int level, int x, int y) {
  DVec3 color(0.0);
  int known = 0;
  const int side = 1 << level;
  for (int row = y * side; row < std::min((y + 1) * side, film.height()); ++row) {
    for (int column = x * side; column < std::min((x + 1) * side, film.width()); ++column) {
      if (film.sample_count(column, row) > 0) {
        color += DVec3(film.mean(column, row));
        ++known;
      }
    }
  }
  const double pixels = static_cast<double>(side) * side;
  return {Rgb(color / pixels), static_cast<float>(known / pixels)};
}

// Batch after batch, sparse and dense, on sides that the tile divides and on others.
TEST(EquirectFilm, PyramidAveragesWhatIsKnown) {
  const Workers workers(2);
  for (const IVec2 size : {IVec2(128, 64), IVec2(100, 50), IVec2(1, 1)}) {
    EquirectFilm film(size.x, size.y);
    for (const std::uint64_t begin : {0U, 40U, 500U, 2000U}) {
      add_samples(sobol_samples(begin, begin / 2 + 30), film, workers);
      for (int level = 0; level < film.levels(); ++level) {
        for (int y = 0; y < film.height(level); ++y) {
          for (int x = 0; x < film.width(level); ++x) {
            const PremultipliedTexel cell = film.cell(level, x, y);
            const PremultipliedTexel expected = average_of_pixels(film, level, x, y);
            ASSERT_LT(glm::distance(cell.color, expected.color), 1e-6F)
                << "level " << level << ": " << x << ", " << y;
            ASSERT_NEAR(cell.weight, expected.weight, 1e-6F);
          }
        }
      }
    }
    EXPECT_EQ(film.width(film.levels() - 1), 1);
    EXPECT_EQ(film.height(film.levels() - 1), 1);
  }
}

// Its memory comes back in another order, in other tiles.
TEST(EquirectFilm, AClearedFilmIsLikeANewOne) {
  const Workers workers(2);
  for (const FilmStatistics statistics :
       {FilmStatistics::mean, FilmStatistics::mean_and_variance}) {
    EquirectFilm cleared(300, 140, statistics);
    for (const std::uint64_t begin : {0U, 20'000U, 50'000U}) {
      add_samples(sobol_samples(begin, 9000), cleared, workers);
      add_samples(in_pixel(77, 99, cleared, 50), cleared, workers);
      cleared.clear();
    }
    EquirectFilm fresh(300, 140, statistics);
    for (EquirectFilm* film : {&cleared, &fresh}) {
      add_samples(sobol_samples(70'000, 3000), *film, workers);
      add_samples(sobol_samples(90'000, 5000), *film, workers);
    }
    EXPECT_EQ(cleared.total_samples(), fresh.total_samples());
    for (int level = 0; level < fresh.levels(); ++level) {
      for (int y = 0; y < fresh.height(level); ++y) {
        for (int x = 0; x < fresh.width(level); ++x) {
          ASSERT_EQ(cleared.cell(level, x, y).color, fresh.cell(level, x, y).color);
          ASSERT_EQ(cleared.cell(level, x, y).weight, fresh.cell(level, x, y).weight);
        }
      }
    }
    for (int y = 0; y < fresh.height(); ++y) {
      for (int x = 0; x < fresh.width(); ++x) {
        ASSERT_EQ(cleared.sample_count(x, y), fresh.sample_count(x, y));
        ASSERT_EQ(cleared.luminance_variance(x, y), fresh.luminance_variance(x, y));
      }
    }
  }
}

TEST(EquirectFilm, KeepsVariancesWhereAsked) {
  const Workers workers(2);
  EquirectFilm film(64, 32, FilmStatistics::mean_and_variance);
  NumberedBatch batch;
  film.number(in_pixel(5, 7, film, 4), batch, workers);
  // A mean far above the deviations, and a sample that does not count.
  const float nan = std::numeric_limits<float>::quiet_NaN();
  film.add(batch, std::vector<Rgb>{Rgb(1000.0F), Rgb(1001.0F), Rgb(nan), Rgb(1005.0F)}, workers);
  EXPECT_NEAR(film.luminance_variance(5, 7).value(), 7.0, 1e-6);  // of 0, 1, 5
  EXPECT_FALSE(film.luminance_variance(6, 7).has_value());
  film.number(in_pixel(40, 7, film, 1), batch, workers);
  film.add(batch, std::vector<Rgb>{Rgb(1.0F)}, workers);
  EXPECT_FALSE(film.luminance_variance(40, 7).has_value());
  film.clear();
  film.number(in_pixel(5, 7, film, 2), batch, workers);
  film.add(batch, std::vector<Rgb>{Rgb(1.0F), Rgb(3.0F)}, workers);
  EXPECT_NEAR(film.luminance_variance(5, 7).value(), 2.0, 1e-6);
  EXPECT_FALSE(EquirectFilm(64, 32).luminance_variance(5, 7).has_value());
}

TEST(EquirectFilm, RefusesImpossibleSizes) {
  EXPECT_THROW(EquirectFilm(0, 10), Error);
  EXPECT_THROW(EquirectFilm(10, -1), Error);
  EXPECT_THROW(EquirectFilm(65537, 10), Error);
}

}  // namespace
}  // namespace foveola
