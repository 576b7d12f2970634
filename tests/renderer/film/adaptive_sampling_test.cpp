#include "renderer/film/adaptive_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/base/numbers/random.h"
#include "renderer/film/sample_pass.h"
#include "renderer/view/equirect.h"
#include "tests/renderer/film/run_pass.h"

namespace foveola {
namespace {

constexpr int film_width_px = 64;
constexpr int film_height_px = 32;
const Vec3 ahead(0.0F, 0.0F, -1.0F);

/// A picture without noise at the left, and at the right one whose pixels are bright once in ten
/// times: the mean is 1 everywhere.
Rgb half_noisy(const SampleJob& job, std::uint32_t seed) {
  if (job.pixel % film_width_px < film_width_px / 2) {
    return Rgb(1.0F);
  }
  const float u = unit_float(mix(mix(mix(seed), job.pixel), job.sample_number));
  return Rgb(u < 0.1F ? 10.0F : 0.0F);
}

/// Renders OD in frames of `per_frame` samples.
EquirectFilm rendered(int frames, std::uint64_t per_frame, std::uint32_t seed,
                      const VisibleNoise& noise, const Vec3& gaze, const Workers& workers) {
  EquirectFilm film(film_width_px, film_height_px, FilmStatistics::mean_and_variance);
  const std::unique_ptr<ViewSampler> od = make_view_sampler("od");
  SamplePass pass;
  for (int frame = 0; frame < frames; ++frame) {
    const auto trace = [&](std::span<const SampleJob> jobs, std::span<Rgb> radiance) {
      std::transform(jobs.begin(), jobs.end(), radiance.begin(),
                     [&](const SampleJob& job) { return half_noisy(job, seed); });
    };
    const auto adjust = [&](std::vector<ViewSample>& samples) {
      redirect_samples(film, gaze, noise, mix(seed, static_cast<std::uint32_t>(frame)), samples,
                       workers);
    };
    test::run_pass(pass, *od, {.first = frame * per_frame, .count = per_frame, .seed = seed}, trace,
                   film, workers, adjust);
  }
  return film;
}

std::uint64_t samples_in_columns(const EquirectFilm& film, int begin, int end) {
  std::uint64_t sum = 0;
  for (int y = 0; y < film_height_px; ++y) {
    for (int x = begin; x < end; ++x) {
      sum += film.sample_count(x, y);
    }
  }
  return sum;
}

TEST(AdaptiveSampling, WhatIsDoneIsLeftAlone) {
  const Workers workers(2);
  const VisibleNoise noise{.contrast = 0.005};
  const EquirectFilm film = rendered(60, 4096, 1, noise, ahead, workers);
  // Away from the border between both halves and from the seam.
  const double done = static_cast<double>(samples_in_columns(film, 2, 30)) / (28 * film_height_px);
  const double noisy =
      static_cast<double>(samples_in_columns(film, 34, 62)) / (28 * film_height_px);
  EXPECT_LT(done, 20.0);
  EXPECT_GT(noisy, 3.0 * done);
  EXPECT_LT(film.total_samples(), 60U * 4096U);
}

// A standard error of 0.8 % of the mean would take 140 000 samples of variance 9. Where Reddy's
// acuity is 7.49 / (0.3 e + 1)^2, that many times its square are enough.
TEST(AdaptiveSampling, TheThresholdFollowsTheAcuity) {
  const Workers workers(2);
  const EquirectFilm film = rendered(60, 4096, 2, {.contrast = 0.008}, ahead, workers);
  const int row = film_height_px / 2;
  const int at_45_deg = film_width_px / 2 + 8;
  const double acuity = 7.49 / std::pow(0.3 * 47.9 + 1.0, 2.0);  // of that pixel's middle
  double sum = 0.0;
  for (int y = row - 3; y < row + 3; ++y) {
    sum += film.sample_count(at_45_deg, y);
  }
  const double expected = 9.0 / (0.008 * 0.008) * acuity * acuity;
  EXPECT_GT(sum / 6.0, 0.5 * expected);
  EXPECT_LT(sum / 6.0, 1.5 * expected);
}

const Vec3 to_the_right(1.0F, 0.0F, 0.0F);

/// The noisy pixels from 39 to 71 degrees around the middle of their half. Under a contrast of 0.01
/// there, samples of variance 9 are enough in numbers of 200 to 20: each pixel stops at its own.
template <typename Visit>
void for_each_stopping_pixel(const EquirectFilm& film, const Visit& visit) {
  for (int y = 0; y < film_height_px; ++y) {
    for (int x = film_width_px / 2; x < film_width_px; ++x) {
      const Vec2 image((static_cast<float>(x) + 0.5F) / film_width_px,
                       (static_cast<float>(y) + 0.5F) / film_height_px);
      const double e = degrees(angle_between(direction_from_equirect(image), to_the_right));
      if (e > 39.0 && e < 71.0) {
        visit(static_cast<std::size_t>(y * film_width_px + x), film.pixel(x, y));
      }
    }
  }
}

struct Estimate {
  double mean = 0.0;
  double standard_error = 0.0;
};

Estimate estimate(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  Estimate result;
  double squares = 0.0;
  for (const double value : values) {
    result.mean += value / n;
    squares += value * value / n;
  }
  result.standard_error = std::sqrt((squares - result.mean * result.mean) / (n - 1.0));
  return result;
}

/// What the means of those pixels differ from 1 by on average, in each of `seeds` renders. Where n
/// samples of mean 1 are stopped without looking ahead, their sum minus n has the mean 0 (Wald's
/// identity): divided by any fixed number it may be taken off a pixel's error, (sum - n) / n. With
/// that number near n less is left of the noise, and all of the bias.
std::vector<double> errors_of_renders(int seeds, const VisibleNoise& noise) {
  const Workers workers(2);
  const auto render = [&](std::uint32_t seed) {
    return rendered(40, 4096, seed, noise, to_the_right, workers);
  };
  constexpr std::uint32_t pilots = 4;
  std::vector<double> usual_count(film_width_px * film_height_px);
  for (std::uint32_t seed = 0; seed < pilots; ++seed) {
    for_each_stopping_pixel(render(50 + seed), [&](std::size_t i, const FilmPixel& pixel) {
      usual_count[i] += pixel.samples / static_cast<double>(pilots);
    });
  }
  std::vector<double> errors;
  for (int i = 0; i < seeds; ++i) {
    double error = 0.0;
    int pixels = 0;
    for_each_stopping_pixel(render(100 + i), [&](std::size_t j, const FilmPixel& pixel) {
      const double own = static_cast<double>(pixel.mean.r) - 1.0;
      error += own - own * pixel.samples / usual_count[j];
      ++pixels;
    });
    errors.push_back(error / pixels);
  }
  return errors;
}

// A rule that stops by a pixel's own samples makes these pixels 3 % too bright.
TEST(AdaptiveSampling, MeansKeepTheirValue) {
  const Estimate error = estimate(errors_of_renders(10, {.contrast = 0.01}));
  EXPECT_LT(error.standard_error, 0.0025);
  EXPECT_LT(std::abs(error.mean), 0.0075);
}

// Rows 2 and down are done but for row 2, which borders on unsampled ones. What is sent away from
// row 5 goes to rows 0 to 2, or over the pole to the same rows half a turn away, and stays spread
// over the pixels there.
TEST(AdaptiveSampling, OverAPoleSamplesComeBackOnItsOtherSide) {
  const Workers workers(1);
  EquirectFilm film(film_width_px, film_height_px, FilmStatistics::mean_and_variance);
  const auto at = [](double x, double y) {
    const Vec2 image(static_cast<float>(x / film_width_px), static_cast<float>(y / film_height_px));
    return ViewSample{.direction = direction_from_equirect(image), .image = image};
  };
  std::vector<ViewSample> fill;
  for (int i = 0; i < 16 * film_width_px * (film_height_px - 2); ++i) {
    fill.push_back(at(i / 16 % film_width_px + 0.5, i / 16 / film_width_px + 2.5));
  }
  NumberedBatch batch;
  film.number(fill, batch, workers);
  film.add(batch, std::vector<Rgb>(fill.size(), Rgb(1.0F)), workers);
  std::vector<ViewSample> samples;
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    const Vec2 point = sobol_2d(i, 9);
    samples.push_back(at(20.0 + point.x, 5.0 + point.y));
  }
  redirect_samples(film, ahead, {}, 3, samples, workers);
  int on_the_other_side = 0;
  std::array<int, 12> in_quarter_rows{};
  for (const ViewSample& sample : samples) {
    ASSERT_LT(sample.image.y * film_height_px, 3.0F);
    ASSERT_GT(sample.image.y, 0.0F);
    EXPECT_LT(glm::distance(sample.direction, direction_from_equirect(sample.image)), 1e-6F);
    const double column = sample.image.x * film_width_px;
    const bool is_near = std::abs(column - 20.5) <= 16.5;
    const bool is_far = std::abs(std::remainder(column - 52.5, film_width_px)) <= 16.5;
    EXPECT_TRUE(is_near || is_far) << column;
    on_the_other_side += is_far ? 1 : 0;
    ++in_quarter_rows.at(static_cast<std::size_t>(sample.image.y * film_height_px * 4.0F));
  }
  EXPECT_GT(on_the_other_side, 500);
  // The four quarters of a row get about as many: multinomial, five standard deviations.
  for (std::size_t row = 0; row < 3; ++row) {
    const auto* quarter = &in_quarter_rows[4 * row];
    const double mean = 0.25 * (quarter[0] + quarter[1] + quarter[2] + quarter[3]);
    EXPECT_GT(mean, 100.0);
    for (int i = 0; i < 4; ++i) {
      EXPECT_NEAR(quarter[i], mean, 5.0 * std::sqrt(mean)) << "row " << row;
    }
  }
}

// With 0.01 on the display as black, a scene of 2^-8 of the light under 8 stops more is the same.
TEST(AdaptiveSampling, WhatIsBlackIsSoAfterTheExposure) {
  const auto total = [](double light, double exposure_stops) {
    const Workers workers(1);
    EquirectFilm film(film_width_px, film_height_px, FilmStatistics::mean_and_variance);
    const std::unique_ptr<ViewSampler> od = make_view_sampler("od");
    SamplePass pass;
    for (std::uint32_t frame = 0; frame < 12; ++frame) {
      const auto trace = [&](std::span<const SampleJob> jobs, std::span<Rgb> radiance) {
        std::transform(jobs.begin(), jobs.end(), radiance.begin(), [&](const SampleJob& job) {
          return half_noisy(job, 4) * static_cast<float>(light);
        });
      };
      const auto adjust = [&](std::vector<ViewSample>& samples) {
        redirect_samples(film, ahead, {.contrast = 0.05, .exposure_stops = exposure_stops}, frame,
                         samples, workers);
      };
      test::run_pass(pass, *od, {.first = frame * 4096, .count = 4096, .seed = 4}, trace, film,
                     workers, adjust);
    }
    return film.total_samples();
  };
  EXPECT_EQ(total(0x1p-8, 8.0), total(1.0, 0.0));
  EXPECT_LT(total(0x1p-8, 0.0), total(1.0, 0.0));
}

TEST(AdaptiveSampling, IsTheSameOnAnyNumberOfThreads) {
  const FilmImage one = rendered(20, 4096, 3, {.contrast = 0.3}, ahead, Workers(1)).resolve();
  const FilmImage four = rendered(20, 4096, 3, {.contrast = 0.3}, ahead, Workers(4)).resolve();
  EXPECT_EQ(one.color.pixels, four.color.pixels);
  EXPECT_EQ(one.samples, four.samples);
}

}  // namespace
}  // namespace foveola
