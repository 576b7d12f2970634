#include "study/prediction/noise_table.h"

#include <cmath>

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

ChannelValues all(double value) { return {value, 2.0 * value, 3.0 * value}; }

/// Noise of 60 / density, from 10 samples a steradian on; black is 4 wrong.
PatchNoise falling_patch(int sample_counts) {
  PatchNoise patch{.cells = 7.0, .contrast = 2.0, .unsampled = all(4.0), .first_per_sr = 10.0};
  patch.noise_times_density.assign(sample_counts, all(60.0));
  return patch;
}

TEST(NoiseTable, NoiseFallsWithTheSamples) {
  const PatchNoise patch = falling_patch(5);
  for (const double density : {10.0, 17.0, 33.0, 40.0, 1e6}) {
    EXPECT_NEAR(noise_at(patch, density)[0], 60.0 / density, 1e-9 / density);
    EXPECT_NEAR(noise_at(patch, density)[2], 180.0 / density, 1e-9 / density);
  }
}

TEST(NoiseTable, BeforeTheFirstLevelThereIsStillBlack) {
  const PatchNoise patch = falling_patch(5);
  EXPECT_EQ(noise_at(patch, 0.0), all(4.0));
  EXPECT_DOUBLE_EQ(noise_at(patch, 5.0)[0], 0.5 * (4.0 + 6.0));
}

TEST(NoiseTable, LevelsAreHalfAnOctaveApart) {
  PatchNoise patch = falling_patch(3);
  patch.noise_times_density[2] = all(120.0);  // at 20 samples a steradian
  EXPECT_NEAR(noise_at(patch, 20.0)[0], 120.0 / 20.0, 1e-9);
  const double midway = 10.0 * std::exp2(0.75);
  EXPECT_NEAR(noise_at(patch, midway)[0], 90.0 / midway, 1e-9);
}

TEST(NoiseTable, AMethodThatNeverGoesThereLeavesBlack) {
  EXPECT_EQ(noise_at(falling_patch(0), 0.0), all(4.0));
}

TEST(NoiseTable, PatchesCountByTheirCells) {
  PatchNoise small = falling_patch(2);
  PatchNoise large = falling_patch(2);
  small.cells = 1.0;
  large.cells = 3.0;
  large.noise_times_density.assign(2, all(100.0));
  large.unsampled = all(8.0);
  const PatchNoise mean = mean_of({small, large});
  EXPECT_EQ(mean.cells, 4.0);
  EXPECT_EQ(mean.unsampled, all(7.0));
  EXPECT_EQ(mean.first_per_sr, 10.0);
  EXPECT_EQ(mean.noise_times_density[1], all(90.0));
}

TEST(NoiseTable, PatchesKeepWhatDoesNotChange) {
  const NoiseTable table = {falling_patch(5), falling_patch(5)};
  const std::vector<PatchEnergies> energies = energies_without_noise(table);
  ASSERT_EQ(energies.size(), 2U);
  EXPECT_EQ(energies[1].cells, 7.0);
  EXPECT_EQ(energies[1].contrast, 2.0);
}

}  // namespace
}  // namespace foveola::study
