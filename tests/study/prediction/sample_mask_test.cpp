#include "study/prediction/sample_mask.h"

#include <cmath>

#include <gtest/gtest.h>

#include "renderer/view/equirect.h"

namespace foveola::study {
namespace {

constexpr Vec3 mask_ahead(0.0F, 0.0F, -1.0F);
constexpr Vec3 behind(0.0F, 0.0F, 1.0F);

ViewSample sample_at(float u, float v) {
  return {.direction = direction_from_equirect({u, v}), .image = {u, v}};
}

const double radius_rad = std::acos(0.97);

class SampleMaskTest : public testing::Test {
 protected:
  std::size_t kept(const ViewSample& sample) const {
    std::vector<ViewSample> samples(3, sample);
    mask_.keep(samples);
    return samples.size();
  }

  Workers workers_{2};
  SampleMask mask_{64, 32};
};

TEST_F(SampleMaskTest, HoldsNothingAtFirst) { EXPECT_EQ(kept(sample_at(0.5F, 0.5F)), 0U); }

TEST_F(SampleMaskTest, KeepsWhatIsWanted) {
  mask_.add(mask_ahead, radius_rad, 0, workers_);
  EXPECT_EQ(kept(sample_at(0.501F, 0.499F)), 3U);
  EXPECT_EQ(kept(sample_at(0.55F, 0.5F)), 0U) << "18 degrees beside";
  EXPECT_EQ(kept(sample_at(0.0F, 0.5F)), 0U);
}

TEST_F(SampleMaskTest, TheMarginGoesBeyondOnAllSides) {
  // In the image's middle, and two pixels from its edge.
  for (const float u : {0.5F, 62.0F / 64.0F}) {
    const Vec3 middle = direction_from_equirect({u, 0.5F});
    SampleMask narrow(64, 32);
    narrow.add(middle, radius_rad, 0, workers_);
    SampleMask wide(64, 32);
    wide.add(middle, radius_rad, 1, workers_);
    // The cone's pixels are a block of 4 x 4, with a margin 6 x 6.
    EXPECT_EQ(narrow.count(), 16U);
    EXPECT_EQ(wide.count(), 36U);
  }
}

TEST_F(SampleMaskTest, TheSeamIsNoEdge) {
  mask_.add(behind, radius_rad, 1, workers_);
  EXPECT_EQ(kept(sample_at(0.001F, 0.5F)), 3U);
  EXPECT_EQ(kept(sample_at(0.999F, 0.5F)), 3U);
}

TEST_F(SampleMaskTest, AreasAddUp) {
  mask_.add(mask_ahead, radius_rad, 0, workers_);
  mask_.add(behind, radius_rad, 0, workers_);
  EXPECT_EQ(kept(sample_at(0.501F, 0.5F)), 3U);
  EXPECT_EQ(kept(sample_at(0.001F, 0.5F)), 3U);
}

}  // namespace
}  // namespace foveola::study
