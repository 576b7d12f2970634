#include "study/prediction/pilot.h"

#include <cmath>

#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/film/viewport_resampler.h"
#include "study/stage/scene_stage.h"
#include "tests/renderer/film/run_pass.h"
#include "tests/study/simulation/small_wall.h"

namespace foveola::study {
namespace {

using test::TemporaryFolder;

Vision some_vision() {
  return {.jnd_lab = 2.3,
          .decay_deg = 0.106,
          .half_resolution_deg = 2.3,
          .recognition_line_pairs = 4.0,
          .surround_factor = 1.5,
          .material_cell_deg = 2.0,
          .view_cell_deg = 6.0,
          .scale_count = 2.0,
          .pooling_exponent = 4.0,

          .object_patch_deg = 4.0,
          .view_patch_deg = 30.0};
}

class PilotTest : public testing::Test {
 protected:
  PilotSetting setting(const SceneStage& stage) const {
    return {.tracer = stage.tracer(),
            .workers = workers_,
            .viewpoint = stage.viewpoint(),
            .film = {.width = 128, .height = 64, .max_depth = 1},
            .jnd_lab = vision_.jnd_lab,
            .stop = stop_.get_token()};
  }
  SampleMask mask(double radius_rad) const {
    SampleMask mask(128, 64);
    mask.add(object().direction, radius_rad, 2, workers_);
    return mask;
  }
  const OfferedObject& object() const { return stage_.objects().front(); }
  std::vector<JudgedView> views() const { return {view_of_object(vision_, object(), display_)}; }

  std::unique_ptr<ViewSampler> aimed(const char* method) const {
    auto sampler = make_view_sampler(method);
    sampler->aim(aim_at(object().direction, DisplaySettings{}));
    return sampler;
  }
  ConvergedMeans expected(const SceneStage& stage) const {
    return converged_means(setting(stage), *aimed("od"), object().direction, 400.0, mask(0.5),
                           views());
  }
  ScaleTables tables(const SceneStage& stage, const char* method, double mask_radius_rad,
                     std::uint32_t picture = 0) const {
    return measure_noise(setting(stage), *aimed(method), levels_, picture, mask(mask_radius_rad),
                         views(), expected(stage))
        .front();
  }

  DisplaySettings display_{.view_width = 64, .view_height = 64};
  TemporaryFolder folder_;
  Workers workers_{2};
  SceneStage stage_{wall_with_a_square(folder_), workers_};
  Vision vision_ = some_vision();
  SampleCountLevels levels_{.first_per_pixel = 1.0, .count = 11};
  std::stop_source stop_;
};

// 12 degrees of radius, half as much around it, and a cell's diagonal of 4: 22 degrees.
TEST_F(PilotTest, WhatIsNotTracedMakesNoDifference) {
  const ScaleTables masked = tables(stage_, "fv", 0.42);
  const ScaleTables whole = tables(stage_, "fv", 3.2);
  ASSERT_EQ(masked.size(), 3U) << "an outline, and a material on two scales";
  ASSERT_GT(masked[0].size(), 20U);
  for (std::size_t scale = 0; scale < masked.size(); ++scale) {
    for (std::size_t i = 0; i < masked[scale].size(); ++i) {
      EXPECT_EQ(masked[scale][i].noise_times_density, whole[scale][i].noise_times_density);
    }
  }
}

TEST_F(PilotTest, EachPictureHasItsOwnNoise) {
  const auto noise = [&](std::uint32_t picture) {
    return tables(stage_, "od", 0.42, picture)[0][0].noise_times_density;
  };
  EXPECT_EQ(noise(1), noise(1));
  EXPECT_NE(noise(1), noise(2));
}

// The ring that fv-paper leaves out is thinner than any patch.
TEST_F(PilotTest, APatchWhoseMiddleIsLeftOutIsReached) {
  const Vec3 middle = tables(stage_, "fv", 0.42)[1][0].direction;
  const double in_ring_rad = radians(5.7926);
  Aim aim = aim_at(object().direction, DisplaySettings{});
  aim.gaze = Frame(middle).to_world(Vec3(std::sin(in_ring_rad), 0.0, std::cos(in_ring_rad)));
  const auto sampler = make_view_sampler("fv-paper");
  sampler->aim(aim);
  ASSERT_EQ(sampler->density_per_sr(middle), 0.0);
  const NoiseTable table =
      measure_noise(setting(stage_), *sampler, levels_, 0, mask(0.42), views(), expected(stage_))
          .front()[1];
  ASSERT_EQ(table[0].noise_times_density.size(), 11U);
  const ChannelValues noise = noise_at(table[0], 32.0 * table[0].first_per_sr);
  EXPECT_LT(noise[0], table[0].unsampled[0]);
}

TEST_F(PilotTest, NoiseFallsWithTheSamples) {
  for (const NoiseTable& table : tables(stage_, "od", 0.42)) {
    double first = 0.0;
    double last = 0.0;
    for (const PatchNoise& patch : table) {
      first += noise_at(patch, patch.first_per_sr)[0];
      last += noise_at(patch, patch.first_per_sr * 32.0)[0];
    }
    EXPECT_LT(last, first / 8.0);
    EXPECT_GT(last, 0.0);
  }
}

/// The noise of all patches together, achromatic, as a display of 48 x 48 shows it after so many
/// samples that were not counted before; the mean of many pictures.
double shown_noise(const PilotSetting& setting, const ViewSampler& sampler, std::uint64_t samples,
                   const Cells& cells, const Viewport& viewport) {
  constexpr int side = 48;
  const CellPixels pixels = pixels_of(cells, viewport, side, side);
  const auto picture = [&](std::uint64_t count, std::uint32_t seed) {
    EquirectFilm film(setting.film.width, setting.film.height);
    SamplePass pass;
    const TraceSettings trace{.max_depth = setting.film.max_depth, .seed = seed};
    test::run_pass(
        pass, sampler, {.first = 0, .count = count, .seed = seed},
        [&](std::span<const SampleJob> jobs, std::span<Rgb> radiance) {
          setting.tracer.trace(setting.viewpoint, jobs, radiance, trace, setting.workers);
        },
        film, setting.workers);
    ViewportResampler resampler(film, {.width = side, .height = side, .exposure_stops = 0.0});
    return cell_means(resampler.show(viewport, setting.workers), pixels, setting.jnd_lab);
  };
  const std::vector<ChannelValues> expected = picture(3'000'000, 1);
  double sum = 0.0;
  constexpr int pictures = 16;
  for (std::uint32_t seed = 100; seed < 100 + pictures; ++seed) {
    for (const PatchEnergies& patch :
         patch_energies(cells, pixels, picture(samples, seed), {expected, expected}, false)) {
      sum += patch.cells * patch.noise[0] / pictures;
    }
  }
  return sum;
}

TEST_F(PilotTest, SeesTheNoiseThatADisplayShows) {
  DisplaySettings display;
  display.view_width = 48;
  display.view_height = 48;
  const std::vector<JudgedView> small = {view_of_object(vision_, object(), display)};
  const PilotSetting pilot = setting(stage_);
  levels_.first_per_pixel = 0.5;
  const auto sampler = aimed("od");
  const ConvergedMeans converged =
      converged_means(pilot, *sampler, object().direction, 400.0, mask(0.6), small);
  constexpr std::uint32_t pictures = 8;
  std::vector<ScaleTables> tables;
  for (std::uint32_t picture = 0; picture < pictures; ++picture) {
    tables.push_back(
        measure_noise(pilot, *sampler, levels_, picture, mask(0.6), small, converged).front());
  }
  for (std::size_t scale = 0; scale < small[0].judged.size(); ++scale) {
    for (const std::uint64_t samples : {8'000U, 30'000U, 100'000U}) {
      double predicted = 0.0;
      for (const ScaleTables& of_picture : tables) {
        for (const PatchNoise& patch : of_picture[scale]) {
          const double per_sr =
              static_cast<double>(samples) * sampler->density_per_sr(patch.direction);
          predicted += patch.cells * noise_at(patch, per_sr)[0] / pictures;
        }
      }
      const double shown =
          shown_noise(pilot, *sampler, samples, small[0].judged[scale].cells, small[0].viewport);
      EXPECT_NEAR(predicted / shown, 1.0, 0.2)
          << "scale " << scale << ", " << samples << " samples";
    }
  }
}

// An evenly lit sky has no noise but that of pixels without samples, which are black: lightness 100
// under white.
TEST_F(PilotTest, KnowsBlackFromWhite) {
  SceneSource sky = wall_with_a_square(folder_);
  sky.file = folder_.write("far.obj", "v 900 900 900\nv 901 900 900\nv 900 901 900\nf 1 2 3\n");
  sky.environment_radiance = Rgb(1.0F);
  sky.lights.clear();
  const SceneStage stage(sky, workers_);
  const NoiseTable material = tables(stage, "od", 0.42)[1];
  const ChannelValues white = opponent_channels(Rgb(1.0F), vision_.jnd_lab);
  const ChannelValues black = opponent_channels(Rgb(0.0F), vision_.jnd_lab);
  const double square = std::pow(white[0] - black[0], 2);
  for (const PatchNoise& patch : material) {
    EXPECT_NEAR(patch.unsampled[0], square, 1e-6 * square);
    EXPECT_NEAR(noise_at(patch, patch.first_per_sr * 32.0)[0], 0.0, 1e-6 * square);
  }
}

TEST_F(PilotTest, StopsWhenItIsAsked) {
  stop_.request_stop();
  EXPECT_THROW(tables(stage_, "od", 0.42), Error);
}

}  // namespace
}  // namespace foveola::study
