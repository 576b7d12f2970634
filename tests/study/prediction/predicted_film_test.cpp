#include "study/prediction/predicted_film.h"

#include <cmath>

#include <gtest/gtest.h>

#include "study/prediction/judged_view.h"

namespace foveola::study {
namespace {

constexpr Vec3 sight_ahead(0.0F, 0.0F, -1.0F);

Vec3 right_of_ahead(double angle_deg) {
  return direction_from({.azimuth_rad = radians(angle_deg), .elevation_rad = 0.0});
}

Aim aimed(const Vec3& gaze) {
  Aim aim = aim_at(sight_ahead, DisplaySettings{});
  aim.gaze = gaze;
  return aim;
}

/// Patches side by side along the horizon whose noise is 1000 over the density of samples.
NoiseTable patches(int count, double apart_deg) {
  NoiseTable table;
  for (int i = 0; i < count; ++i) {
    PatchNoise patch{.direction = right_of_ahead(i * apart_deg),
                     .cells = 4.0,
                     .contrast = 1000.0,
                     .unsampled = {1e6, 0.0, 0.0},
                     .first_per_sr = 1e-3};
    patch.noise_times_density.assign(3, {1000.0, 0.0, 0.0});
    table.push_back(patch);
  }
  return table;
}

Vision sighted() { return {.jnd_lab = 2.3, .half_resolution_deg = 2.3, .pooling_exponent = 4.0}; }

class PredictedFilmTest : public testing::Test {
 protected:
  PredictedTrial trial(bool follows_gaze) const {
    return {.vision = vision_,
            .surround = around_,
            .outline_visibility = visibilities_.front(),
            .material_visibilities = visibilities_,
            .view_visibilities = visibilities_,
            .follows_gaze = follows_gaze};
  }

  Vision vision_ = sighted();
  ObjectNoise picture_{.outline = patches(3, 2.0), .material = {patches(2, 2.0)}};
  std::vector<NoiseTable> around_{patches(20, 9.0)};
  std::vector<Visibility> visibilities_{Visibility(vision_, 1.0)};
};

TEST_F(PredictedFilmTest, SamplesAddUpOverWhereTheyWereSent) {
  const NoiseTable table = patches(3, 5.0);
  const auto sampler = make_view_sampler("fv");
  const auto other = make_view_sampler("fv");
  sampler->aim(aimed(sight_ahead));
  PatchSamples samples(table, *sampler);
  samples.add(100.0);
  samples.add(50.0);
  samples.settle();
  sampler->aim(aimed(right_of_ahead(10.0)));
  samples.add(30.0);
  const std::span<const double> sums = samples.per_sr();
  for (std::size_t i = 0; i < table.size(); ++i) {
    other->aim(aimed(sight_ahead));
    const double first = 150.0 * other->density_per_sr(table[i].direction);
    other->aim(aimed(right_of_ahead(10.0)));
    EXPECT_NEAR(sums[i], first + 30.0 * other->density_per_sr(table[i].direction), 1e-9 * first);
  }
}

// Of one patch, straight at the gaze, where thresholds are 1.
TEST_F(PredictedFilmTest, AMaterialIsSeenThroughTheNoiseOfItsSamples) {
  picture_.material[0].resize(1);
  const PredictedTrial trial = this->trial(false);
  const auto sampler = make_view_sampler("od");
  PredictedFilm sight(trial, picture_, *sampler, aimed(sight_ahead));
  sight.add(5000.0, aimed(sight_ahead));
  const double density = 5000.0 * sampler->density_per_sr(sight_ahead);
  EXPECT_NEAR(sight.look(Task::mark_material, sight_ahead).material_jnd,
              std::sqrt(1000.0 / density), 1e-3);
}

TEST_F(PredictedFilmTest, ATrialSeesItsPicture) {
  ObjectNoise other = picture_;
  for (PatchNoise& patch : other.material[0]) {
    patch.noise_times_density.assign(3, {4000.0, 0.0, 0.0});
  }
  const PredictedTrial trial = this->trial(false);
  const auto jnd_of = [&](const ObjectNoise& picture) {
    const auto sampler = make_view_sampler("od");
    PredictedFilm sight(trial, picture, *sampler, aimed(sight_ahead));
    sight.add(5000.0, aimed(sight_ahead));
    return sight.look(Task::mark_material, sight_ahead).material_jnd;
  };
  EXPECT_NEAR(jnd_of(other) / jnd_of(picture_), 2.0, 1e-4);
}

// By hand: the second scale has 16 times the noise, so 4 times the difference: (1 + 4^4)^(1/4) =
// 4.00390 times.
TEST_F(PredictedFilmTest, AMaterialIsLookedAtOnAllScalesAtOnce) {
  picture_.material[0].resize(1);
  const auto jnd = [&] {
    const PredictedTrial trial = this->trial(false);
    const auto sampler = make_view_sampler("od");
    PredictedFilm sight(trial, picture_, *sampler, aimed(sight_ahead));
    sight.add(5000.0, aimed(sight_ahead));
    return sight.look(Task::mark_material, sight_ahead).material_jnd;
  };
  const double on_one = jnd();
  NoiseTable fine = picture_.material[0];
  fine[0].noise_times_density.assign(3, {16000.0, 0.0, 0.0});
  picture_.material.push_back(fine);
  visibilities_.push_back(visibilities_.front());
  EXPECT_NEAR(jnd() / on_one, 4.00390, 1e-5);
}

TEST_F(PredictedFilmTest, OutlinesStandOutTheMoreSamplesThereAre) {
  const PredictedTrial trial = this->trial(false);
  const auto sampler = make_view_sampler("od");
  PredictedFilm sight(trial, picture_, *sampler, aimed(sight_ahead));
  double before = 0.0;
  for (int i = 0; i < 5; ++i) {
    sight.add(10'000.0, aimed(sight_ahead));
    const double now = sight.look(Task::mark_outline, sight_ahead).outline_signal_to_noise;
    EXPECT_GT(now, before);
    before = now;
  }
}

TEST_F(PredictedFilmTest, SamplesFollowTheGazeThatIsTracked) {
  const PredictedTrial trial = this->trial(true);
  const auto sampler = make_view_sampler("fv");
  const auto jnd = [&](const Vec3& tracked) {
    PredictedFilm sight(trial, picture_, *sampler, aimed(sight_ahead));
    sight.add(10'000.0, aimed(tracked));
    return sight.look(Task::mark_material, sight_ahead).material_jnd;
  };
  EXPECT_LT(1.5 * jnd(sight_ahead), jnd(right_of_ahead(30.0)));
}

TEST_F(PredictedFilmTest, LookingAroundShowsWhatWasRenderedBefore) {
  const PredictedTrial trial = this->trial(false);
  const auto sampler = make_view_sampler("od");
  const auto jnd = [&](double samples_before) {
    PredictedFilm sight(trial, picture_, *sampler, aimed(sight_ahead));
    sight.add(samples_before, aimed(sight_ahead));
    return sight.look(Task::look_around, sight_ahead).artifacts_jnd;
  };
  EXPECT_NEAR(jnd(40'000.0), 0.5 * jnd(10'000.0), 1e-6 * jnd(10'000.0));
}

TEST_F(PredictedFilmTest, ArtifactsAreThoseOfThePlaceThatIsLookedAt) {
  around_[0][19].noise_times_density.assign(3, {1e9, 0.0, 0.0});  // 171 degrees to the right
  const PredictedTrial trial = this->trial(false);
  const auto sampler = make_view_sampler("od");
  PredictedFilm sight(trial, picture_, *sampler, aimed(sight_ahead));
  sight.add(10'000.0, aimed(sight_ahead));
  const double ahead = sight.look(Task::look_around, sight_ahead).artifacts_jnd;
  const double behind = sight.look(Task::look_around, right_of_ahead(171.0)).artifacts_jnd;
  EXPECT_NEAR(behind / ahead, 1e3, 1.0);
}

TEST_F(PredictedFilmTest, WhereNothingCanBeJudgedNoLookCounts) {
  around_[0].clear();
  const PredictedTrial trial = this->trial(false);
  const auto sampler = make_view_sampler("od");
  PredictedFilm sight(trial, picture_, *sampler, aimed(sight_ahead));
  EXPECT_FALSE(std::isfinite(sight.look(Task::look_around, sight_ahead).artifacts_jnd));
}

// Noise is one over the samples there: those of the marks, and those that came while it was looked
// at.
TEST_F(PredictedFilmTest, APlaceThatIsLookedAtFills) {
  const PredictedTrial trial = this->trial(true);
  const auto sampler = make_view_sampler("fv");
  const auto other = make_view_sampler("fv");
  PredictedFilm sight(trial, picture_, *sampler, aimed(sight_ahead));
  sight.add(10'000.0, aimed(sight_ahead));
  const Vec3 aside = right_of_ahead(45.0);
  const double at_first = sight.look(Task::look_around, aside).artifacts_jnd;
  sight.add(3'000.0, aimed(aside));
  const double then = sight.look(Task::look_around, aside).artifacts_jnd;
  other->aim(aimed(sight_ahead));
  const double before_per_sr = 10'000.0 * other->density_per_sr(aside);
  other->aim(aimed(aside));
  const double after_per_sr = before_per_sr + 3'000.0 * other->density_per_sr(aside);
  EXPECT_NEAR(then / at_first, std::sqrt(before_per_sr / after_per_sr), 1e-6);
}

TEST_F(PredictedFilmTest, SamplesAreCountedByWhereTheyWereAimed) {
  const auto sampler = make_view_sampler("fv");
  const auto other = make_view_sampler("fv");
  const auto density = [&](const Vec3& gaze, const Vec3& place) {
    other->aim(aimed(gaze));
    return other->density_per_sr(place);
  };
  SamplesByAim samples(*sampler);
  const Vec3 aside = right_of_ahead(20.0);
  EXPECT_EQ(samples.per_sr(aside), 0.0);
  samples.add(10.0, aimed(sight_ahead));
  samples.add(5.0, aimed(sight_ahead));
  EXPECT_NEAR(samples.per_sr(aside), 15.0 * density(sight_ahead, aside), 1e-9);
  samples.add(7.0, aimed(aside));
  const double at_aside = 15.0 * density(sight_ahead, aside) + 7.0 * density(aside, aside);
  EXPECT_NEAR(samples.per_sr(aside), at_aside, 1e-9 * at_aside);
  const double ahead = 15.0 * density(sight_ahead, sight_ahead) + 7.0 * density(aside, sight_ahead);
  EXPECT_NEAR(samples.per_sr(sight_ahead), ahead, 1e-9 * ahead);
  samples.add(7.0, aimed(aside));
  EXPECT_NEAR(samples.per_sr(aside), at_aside + 7.0 * density(aside, aside), 1e-9 * at_aside);
}

}  // namespace
}  // namespace foveola::study
