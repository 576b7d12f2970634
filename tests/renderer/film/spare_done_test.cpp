#include "renderer/film/spare_done.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/random.h"
#include "renderer/film/sample_pass.h"
#include "renderer/view/equirect.h"

namespace foveola {
namespace {

constexpr int width = 64;
constexpr int height = 32;
const Vec3 ahead(0.0F, 0.0F, -1.0F);

/// A picture without noise at the left, and at the right one whose pixels are bright once in ten
/// times: the mean is 1 everywhere.
Rgb half_noisy(const SampleJob& job, std::uint32_t seed) {
  if (job.pixel % width < width / 2) {
    return Rgb(1.0F);
  }
  const float u = unit_float(mix(mix(mix(seed), job.pixel), job.sample_number));
  return Rgb(u < 0.1F ? 10.0F : 0.0F);
}

/// Renders OD in frames of `per_frame` samples.
EquirectFilm rendered(int frames, std::uint64_t per_frame, std::uint32_t seed,
                      const VisibleNoise& noise, const Workers& workers) {
  EquirectFilm film(width, height, FilmStatistics::mean_and_variance);
  const std::unique_ptr<ViewSampler> od = make_view_sampler("od");
  SamplePass pass;
  for (int frame = 0; frame < frames; ++frame) {
    const auto trace = [&](std::span<const SampleJob> jobs, std::span<Rgb> radiance) {
      std::transform(jobs.begin(), jobs.end(), radiance.begin(),
                     [&](const SampleJob& job) { return half_noisy(job, seed); });
    };
    const auto adjust = [&](std::vector<ViewSample>& samples) {
      spare_done_pixels(film, ahead, noise, mix(seed, static_cast<std::uint32_t>(frame)), samples,
                        workers);
    };
    pass.run(*od, {.first = frame * per_frame, .count = per_frame, .seed = seed}, trace, film,
             workers, adjust);
  }
  return film;
}

std::uint64_t samples_in_columns(const EquirectFilm& film, int begin, int end) {
  std::uint64_t sum = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = begin; x < end; ++x) {
      sum += film.sample_count(x, y);
    }
  }
  return sum;
}

TEST(SpareDonePixels, WhatIsDoneIsLeftAlone) {
  const Workers workers(2);
  const VisibleNoise noise{.contrast = 0.005};
  const EquirectFilm film = rendered(60, 4096, 1, noise, workers);
  // Away from the border between both halves and from the seam.
  const double done = static_cast<double>(samples_in_columns(film, 2, 30)) / (28 * height);
  const double noisy = static_cast<double>(samples_in_columns(film, 34, 62)) / (28 * height);
  EXPECT_LT(done, 20.0);
  EXPECT_GT(noisy, 3.0 * done);
  EXPECT_LT(film.total_samples(), 60U * 4096U);
}

// A standard error of 0.8 % of the mean would take 140 000 samples of variance 9. Where Reddy's
// acuity is 7.49 / (0.3 e + 1)^2, that many times its square are enough.
TEST(SpareDonePixels, TheThresholdFollowsTheAcuity) {
  const Workers workers(2);
  const EquirectFilm film = rendered(60, 4096, 2, {.contrast = 0.008}, workers);
  const int row = height / 2;
  const int at_45_deg = width / 2 + 8;
  const double acuity = 7.49 / std::pow(0.3 * 47.9 + 1.0, 2.0);  // of that pixel's middle
  double sum = 0.0;
  for (int y = row - 3; y < row + 3; ++y) {
    sum += film.sample_count(at_45_deg, y);
  }
  const double expected = 9.0 / (0.008 * 0.008) * acuity * acuity;
  EXPECT_GT(sum / 6.0, 0.5 * expected);
  EXPECT_LT(sum / 6.0, 1.5 * expected);
}

// A stopping rule by a pixel's own variance stops where no bright path was found yet (0.9^16 = 19 %
// of these pixels) and loses as much of the light. The noisy half must keep its mean within four
// standard errors.
TEST(SpareDonePixels, MeansStayUnbiased) {
  const Workers workers(2);
  double sum = 0.0;
  double squares = 0.0;
  constexpr int seeds = 12;
  for (std::uint32_t seed = 0; seed < seeds; ++seed) {
    const EquirectFilm film = rendered(40, 4096, 100 + seed, {.contrast = 0.008}, workers);
    double mean = 0.0;
    for (int y = 0; y < height; ++y) {
      for (int x = width / 2; x < width; ++x) {
        mean += film.mean(x, y).r / (height * width / 2);
      }
    }
    sum += mean;
    squares += mean * mean;
  }
  const double mean = sum / seeds;
  const double standard_error = std::sqrt((squares / seeds - mean * mean) / (seeds - 1));
  EXPECT_NEAR(mean, 1.0, 4.0 * standard_error);
  EXPECT_LT(standard_error, 0.01);
}

TEST(SpareDonePixels, IsTheSameOnAnyNumberOfThreads) {
  const FilmImage one = rendered(20, 4096, 3, {.contrast = 0.3}, Workers(1)).resolve();
  const FilmImage four = rendered(20, 4096, 3, {.contrast = 0.3}, Workers(4)).resolve();
  EXPECT_EQ(one.color.pixels, four.color.pixels);
  EXPECT_EQ(one.samples, four.samples);
}

}  // namespace
}  // namespace foveola
