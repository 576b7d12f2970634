#include "renderer/vision/fov_video_vdp.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/angles.h"
#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/noisy_pair.h"

namespace foveola {
namespace {

using test::noisy_pair;
using test::NoisyPair;

Vec2 half_size(double horizontal_deg, double vertical_deg) {
  return {std::tan(radians(0.5 * horizontal_deg)), std::tan(radians(0.5 * vertical_deg))};
}

/// The displays of these names of pyfvvdp.
VdpDisplay htc_vive_pro() {
  return {.pixels_per_degree = 13.15326,
          .half_size = half_size(87.386, 93.419),
          .white_cd_m2 = 133.3,
          .black_cd_m2 = 0.1};
}
VdpDisplay standard_4k() {
  const double reflected_cd_m2 = 250.0 / std::numbers::pi * 0.005;
  const double half_diagonal = 0.5 * 30.0 * 0.0254 / 0.7472;
  return {.pixels_per_degree = 75.4024,
          .half_size = Vec2(16.0, 9.0) * static_cast<float>(half_diagonal / std::hypot(16.0, 9.0)),
          .white_cd_m2 = 200.0 + reflected_cd_m2,
          .black_cd_m2 = 0.2 + reflected_cd_m2};
}

constexpr std::optional<Vec2> everywhere = std::nullopt;
const std::optional<Vec2> middle = Vec2(256.0F);
const std::optional<Vec2> corner = Vec2(0.0F);

double jod(const NoisyPair& pair, const std::optional<Vec2>& fixation,
           const VdpDisplay& display = htc_vive_pro()) {
  const Workers workers;
  FovVideoVdp vdp(display, {pair.image.width, pair.image.height}, fixation, std::nullopt, workers);
  vdp.add(pair.image, pair.reference);
  return vdp.jod();
}

double jod_of_sequence(bool noise_moves, const std::optional<Vec2>& fixation) {
  const Workers workers;
  FovVideoVdp vdp(htc_vive_pro(), {512, 512}, fixation, 60.0, workers);
  for (std::uint32_t frame = 0; frame < 12; ++frame) {
    const NoisyPair pair = noisy_pair(24.0, noise_moves ? frame : 0);
    vdp.add(pair.image, pair.reference);
  }
  return vdp.jod();
}

TEST(VdpSensitivity, HasTheCheckValues) {
  // Of an independent program.
  struct Check {
    double frequency_cpd, luminance_cd_m2, eccentricity_deg, sensitivity;
  };
  for (const Check& check :
       {Check{1, 10, 0, 121.493}, Check{4, 10, 0, 37.889}, Check{4, 100, 0, 56.417},
        Check{1, 10, 20, 53.400}, Check{4, 100, 10, 18.335}, Check{0.5, 1, 5, 84.511},
        Check{16, 100, 0, 5.675}}) {
    EXPECT_NEAR(vdp_sensitivity(VdpChannel::sustained, check.frequency_cpd, check.luminance_cd_m2,
                                check.eccentricity_deg) /
                    check.sensitivity,
                1.0, 1e-4);
  }
}

TEST(FovVideoVdp, RatesPicturesAsPyfvvdpDoes) {
  const NoisyPair pair = noisy_pair();
  EXPECT_NEAR(jod(pair, everywhere), 8.0349, 0.002);
  EXPECT_NEAR(jod(pair, middle), 9.6340, 0.002);
  EXPECT_NEAR(jod(pair, corner), 9.8412, 0.002);
  EXPECT_NEAR(jod(pair, everywhere, standard_4k()), 9.6704, 0.002);
}

TEST(FovVideoVdp, RatesASequenceAsPyfvvdpDoes) {
  EXPECT_NEAR(jod_of_sequence(true, middle), 9.4898, 0.01);
}

TEST(FovVideoVdp, RatesMoreSequencesAsPyfvvdpDoes) {
  EXPECT_NEAR(jod_of_sequence(false, everywhere), 8.0281, 0.01);
  EXPECT_NEAR(jod_of_sequence(false, middle), 9.6333, 0.01);
  EXPECT_NEAR(jod_of_sequence(false, corner), 9.8409, 0.01);
  EXPECT_NEAR(jod_of_sequence(true, everywhere), 7.2626, 0.01);
  EXPECT_NEAR(jod_of_sequence(true, corner), 9.8056, 0.01);
}

TEST(FovVideoVdp, FallsWithNoise) {
  const NoisyPair equal = noisy_pair();
  EXPECT_EQ(jod({equal.reference, equal.reference}, middle), 10.0);
  double before = 10.0;
  for (const double noise : {6.0, 12.0, 24.0, 48.0}) {
    const double found = jod(noisy_pair(noise), middle);
    EXPECT_LT(found, before) << noise;
    before = found;
  }
}

TEST(FovVideoVdp, RisesAsTheEyeLeavesANoisyPatch) {
  NoisyPair pair = noisy_pair(48.0);
  // 5 degrees wide, in the middle.
  const double pixels_per_degree = 512.0 / 87.386;
  for (int y = 0; y < 512; ++y) {
    for (int x = 0; x < 512; ++x) {
      if (std::hypot(x - 255.5, y - 255.5) > 2.5 * pixels_per_degree) {
        pair.image.at(x, y) = pair.reference.at(x, y);
      }
    }
  }
  double before = 0.0;
  for (const float x : {256.0F, 320.0F, 384.0F, 448.0F, 511.0F}) {
    const double found = jod(pair, Vec2(x, 256.0F));
    EXPECT_GT(found, before) << x;
    before = found;
  }
}

TEST(FovVideoVdp, TakesAnySizeThatHasPixels) {
  for (const IVec2& size : {IVec2(1, 1), IVec2(2, 3), IVec2(97, 61), IVec2(640, 1)}) {
    const double found = jod(noisy_pair(24.0, 0, size), Vec2(0.5F));
    EXPECT_LE(found, 10.0);
    EXPECT_TRUE(std::isfinite(found));
  }
}

TEST(FovVideoVdp, RefusesWhatMakesNoSense) {
  const Workers workers;
  const auto expect_refused = [&](const VdpDisplay& display, const std::optional<Vec2>& fixation,
                                  const std::optional<double>& rate_hz, const char* words) {
    EXPECT_THAT([&] { FovVideoVdp(display, {64, 64}, fixation, rate_hz, workers); },
                ThrowsMessage<Error>(HasSubstr(words)));
  };
  VdpDisplay dark = htc_vive_pro();
  dark.white_cd_m2 = 0.0;
  VdpDisplay blinding = htc_vive_pro();
  blinding.white_cd_m2 = 1e7;
  expect_refused({}, everywhere, std::nullopt, "has no size");
  expect_refused(dark, everywhere, std::nullopt, "white");
  expect_refused(blinding, everywhere, std::nullopt, "white");
  expect_refused(htc_vive_pro(), Vec2(65.0F, 1.0F), std::nullopt, "outside");
  expect_refused(htc_vive_pro(), Vec2(std::numeric_limits<float>::quiet_NaN(), 1.0F), std::nullopt,
                 "outside");
  for (const double rate : {0.0, -1.0, 1000.5, std::numeric_limits<double>::quiet_NaN()}) {
    expect_refused(htc_vive_pro(), everywhere, rate, "frames");
  }
  FovVideoVdp vdp(htc_vive_pro(), {512, 512}, everywhere, std::nullopt, workers);
  NoisyPair pair = noisy_pair();
  EXPECT_THAT([&] { vdp.add(pair.image, RgbImage(511, 512)); },
              ThrowsMessage<Error>(HasSubstr("511")));
  pair.image.at(3, 4).g = std::numeric_limits<float>::infinity();
  EXPECT_THAT([&] { vdp.add(pair.image, pair.reference); },
              ThrowsMessage<Error>(HasSubstr("finite")));
}

}  // namespace
}  // namespace foveola
