#include "analysis/convergence/scorer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "renderer/view/equirect.h"

namespace foveola::analysis {
namespace {

constexpr double fov_rad = radians(90.0);

RgbImage plain(const IVec2& size, float value) {
  RgbImage image(size.x, size.y);
  std::fill(image.pixels.begin(), image.pixels.end(), Rgb(value));
  return image;
}

class ScorerTest : public testing::Test {
 protected:
  ScorerTest() {
    plan_.size = {64, 32};
    plan_.view_size = 120;
  }

  Scorer scorer(float first, float second) const {
    return {
        plan_,   viewport_, 0.0, regions_, {plain(plan_.size, first), plain(plan_.size, second)},
        workers_};
  }

  /// A film whose pixels that `has_sample` says have one sample of `value`.
  template <typename HasSample>
  EquirectFilm film(float value, const HasSample& has_sample) const {
    EquirectFilm film(plan_.size.x, plan_.size.y);
    std::vector<ViewSample> samples;
    for (int y = 0; y < plan_.size.y; ++y) {
      for (int x = 0; x < plan_.size.x; ++x) {
        if (has_sample(x, y)) {
          const Vec2 middle((x + 0.5) / 64.0, (y + 0.5) / 32.0);
          samples.push_back({.direction = direction_from_equirect(middle), .image = middle});
        }
      }
    }
    NumberedBatch batch;
    film.number(samples, batch, workers_);
    film.add(batch, std::vector<Rgb>(samples.size(), Rgb(value)), workers_);
    return film;
  }

  const Score& named(const std::vector<Score>& scores, const std::string& name) const {
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      if (regions_[i].name == name) {
        return scores[i];
      }
    }
    throw std::logic_error(name);
  }

  ConvergencePlan plan_;
  Viewport viewport_{head_orientation({}), fov_rad, fov_rad};
  Vec3 gaze_{0.0F, 0.0F, -1.0F};
  std::vector<Region> regions_ = regions_around(gaze_, viewport_);
  Workers workers_{1};
};

TEST_F(ScorerTest, ComparesEveryRegionWithBothHalves) {
  const std::vector<Score> scores =
      scorer(0.25F, 0.75F).score(film(1.0F, [](int, int) { return true; }));
  ASSERT_EQ(scores.size(), regions_.size());
  for (const char* region : {"10deg", "20deg", "viewport", "acuity", "sphere"}) {
    const Score& score = named(scores, region);
    EXPECT_NEAR(score.error.mse, 0.75 * 0.25, 1e-9);
    EXPECT_NEAR(score.error.samples_per_pixel, 1.0, 1e-9);
    EXPECT_EQ(score.error.empty, 0U);
  }
  // No middle of this film's pixels is so near.
  EXPECT_TRUE(std::isnan(named(scores, "2deg").error.mse));
}

// Black against white on a plain display; test FLIP has where this comes from.
TEST_F(ScorerTest, ShowsUnsampledPixelsBlack) {
  const std::vector<Score> scores =
      scorer(1.0F, 1.0F).score(film(1.0F, [](int x, int) { return x < 4; }));
  EXPECT_NEAR(named(scores, "viewport").flip.value_or(0.0), 0.9674, 1e-3);
  EXPECT_EQ(named(scores, "viewport").error.empty_share, 1.0);
  EXPECT_NEAR(named(scores, "sphere").error.empty_share, 60.0 / 64.0, 1e-6);
  EXPECT_FALSE(named(scores, "sphere").flip.has_value());
}

TEST_F(ScorerTest, SeesNoDifferenceWhereThereIsNone) {
  const std::vector<Score> scores =
      scorer(0.5F, 0.5F).score(film(0.5F, [](int, int) { return true; }));
  EXPECT_NEAR(named(scores, "10deg").flip.value_or(1.0), 0.0, 1e-5);
  EXPECT_NEAR(named(scores, "10deg").error.mse, 0.0, 1e-12);
}

}  // namespace
}  // namespace foveola::analysis
