#include "renderer/progressive/headless_render.h"

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "renderer/base/work/shard.h"
#include "renderer/film/equirect_film.h"
#include "renderer/view/equirect.h"
#include "renderer/view/view_sampler.h"

namespace foveola {
namespace {

/// Where the samples of a method fall in an image of 1024 x 512.
std::vector<IVec2> sampled_pixels(const std::string& method, const AzimuthElevation& gaze) {
  constexpr std::size_t count = 1 << 20;
  const EquirectFilm film(1024, 512);
  std::vector<Vec2> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    points[i] = sobol_2d(i, 1);
  }
  std::vector<ViewSample> samples(count);
  const std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
  sampler->aim({.viewport = Viewport(gaze, FieldOfView{}), .gaze = direction_from(gaze)});
  sampler->sample(points, samples);
  std::vector<IVec2> pixels;
  for (const ViewSample& sample : samples) {
    pixels.push_back(film.pixel_at(sample.image));
  }
  return pixels;
}

/// The samples of the part that has most, over the mean.
double longest_over_mean(const std::vector<IVec2>& pixels, std::int64_t shards) {
  std::vector<double> samples_of(static_cast<std::size_t>(shards));
  for (const IVec2& pixel : pixels) {
    samples_of.at(static_cast<std::size_t>(shard_of_pixel(pixel, shards) - 1)) += 1.0;
  }
  return *std::max_element(samples_of.begin(), samples_of.end()) * static_cast<double>(shards) /
         static_cast<double>(pixels.size());
}

// Dealt by the film's own tiles, of 32 pixels, 8 parts of fv came to 1.8, and 64 to 7.8. The
// viewport has so few small tiles that 64 parts come to 1.08.
TEST(TileDealing, AllPartsHaveAboutAsManySamples) {
  for (const std::string method : {"od", "vp", "fv"}) {
    for (const double elevation_rad : {0.0, 0.7, -1.5}) {
      const std::vector<IVec2> pixels =
          sampled_pixels(method, {.azimuth_rad = 0.4, .elevation_rad = elevation_rad});
      for (const std::int64_t shards : {2, 3, 8, 16, 40, 64}) {
        EXPECT_LT(longest_over_mean(pixels, shards), shards > 40 ? 1.1 : 1.06)
            << method << " at " << elevation_rad << " in " << shards;
      }
    }
  }
}

TEST(TileDealing, EveryPixelIsOfOnePart) {
  EXPECT_EQ(shard_of_pixel({700, 300}, 1), 1);
  const IVec2 last(EquirectFilm::largest_side - 1);
  for (const std::int64_t shards : {std::int64_t{7}, max_shards}) {
    for (const IVec2 pixel : {IVec2(0), IVec2(last.x, 0), IVec2(0, last.y), last}) {
      EXPECT_GE(shard_of_pixel(pixel, shards), 1);
      EXPECT_LE(shard_of_pixel(pixel, shards), shards);
    }
  }
  std::set<std::int64_t> dealt;
  for (int column = 0; column < 7; ++column) {
    dealt.insert(shard_of_pixel({4 * column, last.y}, 7));
  }
  EXPECT_EQ(dealt, (std::set<std::int64_t>{1, 2, 3, 4, 5, 6, 7}));
}

}  // namespace
}  // namespace foveola
