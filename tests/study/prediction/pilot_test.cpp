#include "study/prediction/pilot.h"

#include <cmath>

#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "study/stage/scene_stage.h"
#include "tests/study/commands/small_wall.h"

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
          .object_patch_deg = 4.0,
          .view_patch_deg = 30.0};
}

class PilotTest : public testing::Test {
 protected:
  static constexpr double pixel_rad = 0.035;

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
  std::vector<JudgedView> views() const {
    return {view_of_outline(vision_, object(), pixel_rad),
            view_of_material(vision_, object(), pixel_rad)};
  }
  std::unique_ptr<ViewSampler> aimed(const char* method) const {
    auto sampler = make_view_sampler(method);
    sampler->aim(aim_at(object().direction, DisplaySettings{}));
    return sampler;
  }
  CellMeans expected(const SceneStage& stage) const {
    return converged_means(setting(stage), *aimed("od"), object().direction, 400.0, mask(0.5),
                           views());
  }
  std::vector<NoiseTable> tables(const SceneStage& stage, const char* method,
                                 double mask_radius_rad) const {
    return measure_noise(setting(stage), *aimed(method), ladder_, mask(mask_radius_rad), views(),
                         expected(stage));
  }

  TemporaryFolder folder_;
  Workers workers_{2};
  SceneStage stage_{wall_with_a_square(folder_), workers_};
  Vision vision_ = some_vision();
  PilotLadder ladder_{.first_per_pixel = 1.0, .rungs = 11, .repetitions = 2};
  std::stop_source stop_;
};

// 12 degrees of radius, half as much around it, and a cell's diagonal of 4: 22 degrees.
TEST_F(PilotTest, WhatIsNotTracedMakesNoDifference) {
  const std::vector<NoiseTable> masked = tables(stage_, "fv", 0.42);
  const std::vector<NoiseTable> whole = tables(stage_, "fv", 3.2);
  ASSERT_EQ(masked.size(), 2U);
  ASSERT_GT(masked[0].size(), 20U);
  for (std::size_t view = 0; view < 2; ++view) {
    for (std::size_t i = 0; i < masked[view].size(); ++i) {
      EXPECT_EQ(masked[view][i].noise_times_density, whole[view][i].noise_times_density);
    }
  }
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
