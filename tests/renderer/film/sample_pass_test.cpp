#include "renderer/film/sample_pass.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "renderer/base/numbers/random.h"
#include "renderer/view/equirect.h"
#include "renderer/view/image_samplers.h"
#include "tests/matchers.h"
#include "tests/renderer/film/run_pass.h"
#include "tests/renderer/view/every_method.h"
#include "tests/renderer/view/test_images.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

/// A tracer's stand-in: the colour is the direction's.
void trace_direction(std::span<const SampleJob> jobs, std::span<Rgb> radiance) {
  std::transform(jobs.begin(), jobs.end(), radiance.begin(),
                 [](const SampleJob& job) { return 0.5F * (job.direction + 1.0F); });
}

TEST(SamplePass, BringsTheSequencesPointsToTheirPixels) {
  const Workers workers(2);
  const std::unique_ptr<ViewSampler> od = make_view_sampler("od");
  EquirectFilm film(64, 32);
  SamplePass pass;
  const PointRange points = {.first = 1000, .count = 9000, .seed = 4};
  EXPECT_TRUE(test::run_pass(pass, *od, points, trace_direction, film, workers).empty());
  std::vector<std::uint32_t> expected(64 * 32, 0);
  for (std::uint64_t i = 1000; i < 10'000; ++i) {
    const Vec2 point = sobol_2d(i, 4);
    ++expected[static_cast<std::size_t>(point.y * 32.0F) * 64 +
               static_cast<std::size_t>(point.x * 64.0F)];
  }
  EXPECT_EQ(film.resolve().samples, expected);
  const Rgb ahead = 0.5F * (direction_from_equirect({32.5F / 64.0F, 16.5F / 32.0F}) + 1.0F);
  EXPECT_LT(glm::distance(film.mean(32, 16), ahead), 0.05F);
}

/// Radiance that grows towards `ahead`'s far side, linearly over each pixel from 0.1 to 1.9.
Rgb ramp(const EquirectFilm& film, const SampleJob& job, const Vec3& ahead) {
  const Vec2 size(film.width(), film.height());
  const Vec2 place = equirect_from_direction(job.direction) * size;
  const Vec2 middle = glm::floor(place) + 0.5F;
  const Vec2 outwards = glm::normalize(middle - equirect_from_direction(ahead) * size);
  return Rgb(1.0F + 0.9F * 2.0F / (std::abs(outwards.x) + std::abs(outwards.y)) *
                        glm::dot(place - middle, outwards));
}

// The ramp's mean over a pixel's area is 1, wherever the pixel is. By samples alone it is a third
// of the products of both variations less: 4 % by FV at 8 degrees, 1 % by VP at 45.
TEST(SamplePass, MeansAreThoseOfAPixelsArea) {
  const Workers workers(2);
  const Vec3 ahead(0, 0, -1);
  const Viewport viewport(Quat(1, 0, 0, 0), radians(100.0), radians(100.0));
  for (const auto& [method, nearest_deg, farthest_deg] :
       {std::tuple("fv", 6.5, 12.0), std::tuple("vp", 40.0, 46.0)}) {
    const std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
    sampler->aim({.viewport = viewport, .gaze = ahead});
    EquirectFilm film(180, 90, FilmStatistics::mean_and_variance);
    SamplePass pass;
    test::run_pass(
        pass, *sampler, {.count = 1 << 21, .seed = 3},
        [&](std::span<const SampleJob> jobs, std::span<Rgb> radiance) {
          std::transform(jobs.begin(), jobs.end(), radiance.begin(),
                         [&](const SampleJob& job) { return ramp(film, job, ahead); });
        },
        film, workers);
    double sum = 0.0;
    int pixels = 0;
    for (int y = 0; y < film.height(); ++y) {
      for (int x = 0; x < film.width(); ++x) {
        const Vec2 middle((static_cast<float>(x) + 0.5F) / 180.0F,
                          (static_cast<float>(y) + 0.5F) / 90.0F);
        const double off = degrees(angle_between(direction_from_equirect(middle), ahead));
        if (off > nearest_deg && off < farthest_deg) {
          sum += film.mean(x, y).g;
          ++pixels;
        }
      }
    }
    ASSERT_GT(pixels, 50);
    EXPECT_NEAR(sum / pixels, 1.0, 1e-3) << method;
  }
}

TEST(SamplePass, EqualSamplesHaveTheirMeanWhateverTheirWeights) {
  const Workers workers(2);
  const std::unique_ptr<ViewSampler> fv = make_view_sampler("fv");
  fv->aim({.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0)});
  EquirectFilm film(90, 45, FilmStatistics::mean_and_variance);
  SamplePass pass;
  test::run_pass(
      pass, *fv, {.count = 100'000, .seed = 3},
      [](std::span<const SampleJob>, std::span<Rgb> radiance) {
        std::fill(radiance.begin(), radiance.end(), Rgb(0.7F));
      },
      film, workers);
  film.for_each_sampled_pixel([&](const IVec2& at, const FilmTile::Pixel& pixel) {
    EXPECT_FLOAT_EQ(pixel.mean().g, 0.7F);
    EXPECT_NEAR(film.luminance_variance(at.x, at.y).value_or(0.0), 0.0, 1e-9);
  });
}

// OD maps the unit square to the image as it is, so the net's equal boxes are the pixels.
TEST(SamplePass, WholeNetsGiveEveryPixelTheSame) {
  const Workers workers(2);
  const std::unique_ptr<ViewSampler> od = make_view_sampler("od");
  for (const std::uint32_t seed : {0U, 1U, 77U}) {
    EquirectFilm film(128, 64);
    SamplePass pass;
    test::run_pass(pass, *od, {.first = 0, .count = 128 * 64 * 8, .seed = seed}, trace_direction,
                   film, workers);
    EXPECT_THAT(film.resolve().samples, Each(8U));
  }
}

// Neither side of most sizes is a power of two; with Sobol points alone 18 to 24 % of the pixels of
// those had nothing after a round.
TEST(SamplePass, VisitsInRoundsDifferByOneAtMost) {
  const Workers workers(2);
  const std::unique_ptr<ViewSampler> od = make_view_sampler("od");
  const std::unique_ptr<ViewSampler> picture = make_picture_sampler();
  picture->aim({.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0)});
  for (const IVec2 size : {IVec2(1917, 1079), IVec2(1280, 720), IVec2(64, 64), IVec2(3, 1)}) {
    for (const ViewSampler* sampler : {od.get(), picture.get()}) {
      ASSERT_TRUE(sampler->keeps_points());
      EquirectFilm film(size.x, size.y);
      SamplePass pass;
      PointRange points = {.seed = 7, .cells = size};
      const auto counts_at = [&](std::uint64_t end) {
        points.count = end - points.first;
        test::run_pass(pass, *sampler, points, trace_direction, film, workers);
        points.first = end;
        const std::vector<std::uint32_t> counts = film.resolve().samples;
        const auto [fewest, most] = std::minmax_element(counts.begin(), counts.end());
        return std::pair(*fewest, *most);
      };
      const std::uint64_t pixels = static_cast<std::uint64_t>(size.x) * size.y;
      EXPECT_EQ(counts_at(pixels / 3), std::pair(0U, 1U));
      EXPECT_EQ(counts_at(pixels), std::pair(1U, 1U));
      EXPECT_EQ(counts_at(pixels + pixels / 3), std::pair(1U, 2U));
    }
  }
}

// The mean of a place that is uniform in [0, 1) has a variance of 1/12 over the number of samples;
// that of one place in each of four equal parts has 1/12 / 4^3.
TEST(SamplePass, RoundsStratifyEachPixel) {
  const Workers workers(2);
  const std::unique_ptr<ViewSampler> od = make_view_sampler("od");
  constexpr IVec2 size(100, 75);
  const auto place_in_pixel = [&](std::span<const SampleJob> jobs, std::span<Rgb> radiance) {
    std::transform(jobs.begin(), jobs.end(), radiance.begin(), [&](const SampleJob& job) {
      return Rgb(glm::fract(equirect_from_direction(job.direction) * Vec2(size)), 0.0F);
    });
  };
  EquirectFilm film(size.x, size.y);
  SamplePass pass;
  test::run_pass(pass, *od, {.count = 4 * 100 * 75, .seed = 3, .cells = size}, place_in_pixel, film,
                 workers);
  DVec2 variance(0.0);
  for (const Rgb& mean : film.resolve().color.pixels) {
    const DVec2 error = DVec2(mean) - 0.5;
    variance += error * error / (100.0 * 75.0);
  }
  EXPECT_NEAR(variance.x, 1.0 / 768.0, 0.1 / 768.0);
  EXPECT_NEAR(variance.y, 1.0 / 768.0, 0.1 / 768.0);
}

// A third of a round: squares of 20 x 20 pixels hold 133 points each. As many at random would
// differ by 9.4 (a standard deviation, without replacement), Sobol points by about 1.
TEST(SamplePass, ARoundFillsTheFilmEvenly) {
  const Workers workers(2);
  const std::unique_ptr<ViewSampler> od = make_view_sampler("od");
  constexpr IVec2 size(640, 480);
  EquirectFilm film(size.x, size.y);
  SamplePass pass;
  test::run_pass(pass, *od, {.count = 640 * 480 / 3, .seed = 5, .cells = size}, trace_direction,
                 film, workers);
  double variance = 0.0;
  for (int square = 0; square < 32 * 24; ++square) {
    double count = 0.0;
    for (int i = 0; i < 400; ++i) {
      count += film.sample_count(square % 32 * 20 + i % 20, square / 32 * 20 + i / 20);
    }
    variance += (count - 400.0 / 3.0) * (count - 400.0 / 3.0) / (32.0 * 24.0);
  }
  EXPECT_LT(std::sqrt(variance), 8.0);
}

TEST(SamplePass, CutsAndThreadsDoNotMatter) {
  const std::unique_ptr<ViewSampler> fv = make_view_sampler("fv");
  fv->aim({.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0), .gaze = Vec3(0.6F, 0.8F, 0.0F)});
  const auto film = [&](int threads, const std::vector<std::uint64_t>& counts) {
    const Workers workers(threads);
    EquirectFilm result(100, 50);
    SamplePass pass;
    PointRange points = {.seed = 9};
    for (const std::uint64_t count : counts) {
      points.count = count;
      test::run_pass(pass, *fv, points, trace_direction, result, workers);
      points.first += count;
    }
    return result.resolve();
  };
  const FilmImage expected = film(1, {20'000});
  for (const FilmImage& image : {film(4, {20'000}), film(2, {1, 0, 7000, 12'999})}) {
    EXPECT_EQ(image.color.pixels, expected.color.pixels);
    EXPECT_EQ(image.samples, expected.samples);
  }
}

/// A colour that depends on the job alone, over so many powers of two that a sum depends on the
/// order of its terms.
Rgb wide_ranging(const SampleJob& job) {
  const std::uint32_t bits = mix(mix(job.pixel), job.sample_number);
  const float value = unit_float(bits) * std::exp2(static_cast<float>(bits % 64));
  return {value, 0.3F * value, 1.7F * value};
}

class EveryMethod : public testing::TestWithParam<std::string> {};

// 128 tiles of 32 x 32 pixels: several tasks for each thread, in numbering and in adding.
TEST_P(EveryMethod, TheFilmIsTheSameToTheLastBitOnAnyNumberOfThreads) {
  const test::TemporaryFolder folder;
  const std::string method = test::with_images(GetParam(), folder.path());
  const Vec3 gaze = direction_from({.azimuth_rad = 2.9, .elevation_rad = -0.4});
  const auto film = [&](int threads) {
    const Workers workers(threads);
    const std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
    sampler->aim({.viewport = Viewport(head_orientation({.azimuth_rad = 2.5}), 1.7, 1.4),
                  .gaze = gaze,
                  .pointer = gaze});
    EquirectFilm result(512, 256, FilmStatistics::mean_and_variance);
    SamplePass pass;
    const auto trace = [&](std::span<const SampleJob> jobs, std::span<Rgb> radiance) {
      std::transform(jobs.begin(), jobs.end(), radiance.begin(), wide_ranging);
    };
    constexpr std::uint64_t per_pass = 30'000;
    for (std::uint64_t first = 0; first < 3 * per_pass; first += per_pass) {
      test::run_pass(pass, *sampler, {.first = first, .count = per_pass, .seed = 5}, trace, result,
                     workers);
    }
    return result;
  };
  const EquirectFilm one = film(1);
  const FilmImage expected = one.resolve();
  for (const int threads : {2, 4}) {
    const EquirectFilm other = film(threads);
    const FilmImage image = other.resolve();
    EXPECT_EQ(image.color.pixels, expected.color.pixels) << threads << " threads";
    EXPECT_EQ(image.samples, expected.samples) << threads << " threads";
    for (int y = 0; y < one.height(); ++y) {
      for (int x = 0; x < one.width(); ++x) {
        ASSERT_EQ(other.luminance_variance(x, y), one.luminance_variance(x, y));
      }
    }
    for (int level = 1; level < one.levels(); ++level) {
      for (int y = 0; y < one.height(level); ++y) {
        for (int x = 0; x < one.width(level); ++x) {
          ASSERT_EQ(other.cell(level, x, y).color, one.cell(level, x, y).color);
          ASSERT_EQ(other.cell(level, x, y).weight, one.cell(level, x, y).weight);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AnyThreads, EveryMethod, testing::ValuesIn(test::every_method));

}  // namespace
}  // namespace foveola
