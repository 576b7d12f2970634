#include "renderer/view/mask_sampler.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/renderer/view/test_images.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

const Vec3 left(-1.0F, 0.0F, 0.0F);
const Vec3 right(1.0F, 0.0F, 0.0F);
const Aim aim{.viewport = Viewport(Quat(1, 0, 0, 0), 1.0, 1.0)};

double left_half(double x, double) { return x < 0.5 ? 1.0 : 0.0; }
double right_half(double x, double) { return x < 0.5 ? 0.0 : 1.0; }

class Mask : public testing::Test {
 protected:
  void paint(double weight(double x, double y)) {
    test::write_weights(path_, 8, 4, weight);
    touch();
  }
  void write(const std::string& bytes) {
    std::ofstream(path_, std::ios::binary) << bytes;
    touch();
  }
  /// A test is faster than the clock of the file system may be.
  void touch() {
    ++seconds_;
    std::filesystem::last_write_time(
        path_, std::filesystem::file_time_type::clock::now() + std::chrono::seconds(seconds_));
  }
  std::string complaint() const {
    return test::error_of([&] { const MaskSampler sampler(path_, 0.0); });
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "mask.exr";
  int seconds_ = 0;
};

TEST_F(Mask, LiesOverTheEquirectImage) {
  paint([](double x, double y) { return x < 0.5 && y < 0.5 ? 1.0 : 0.0; });
  const MaskSampler sampler(path_, 0.0);
  // All of the samples in a quarter of the image: 4 / (2 pi^2 cos(elevation)).
  constexpr double pi = 3.14159265358979;
  EXPECT_NEAR(sampler.density_per_sr({-1.0F, 1.0F, 0.0F}), 4.0 / (2.0 * pi * pi * std::sqrt(0.5)),
              1e-5);
  EXPECT_EQ(sampler.density_per_sr({1.0F, 1.0F, 0.0F}), 0.0);
  EXPECT_EQ(sampler.density_per_sr({-1.0F, -1.0F, 0.0F}), 0.0);
}

// A floor of 1 adds the mean, 0.5, to 1 and to 0.
TEST_F(Mask, TheFloorFeedsWhatIsBlack) {
  paint(left_half);
  const MaskSampler sampler(path_, 1.0);
  EXPECT_NEAR(sampler.density_per_sr(left) / sampler.density_per_sr(right), 3.0, 1e-5);
}

// A floor of 10^6 means of 0.5 x 10^38 leaves 2 parts in 10^6 between white and black.
TEST_F(Mask, AHighFloorUnderLargeWeightsOverflowsNothing) {
  paint([](double x, double) { return x < 0.5 ? 1e38 : 0.0; });
  const MaskSampler sampler(path_, 1e6);
  EXPECT_NEAR(sampler.density_per_sr(left) / sampler.density_per_sr(right), 1.0, 1e-5);
  constexpr double pi = 3.14159265358979;
  EXPECT_NEAR(sampler.density_per_sr(left), 1.0 / (2.0 * pi * pi), 1e-5);
}

TEST_F(Mask, IsReadAnewWhenItIsPaintedOn) {
  paint(left_half);
  MaskSampler sampler(path_, 0.0);
  sampler.aim(aim);
  EXPECT_GT(sampler.density_per_sr(left), 0.0);
  paint(right_half);
  EXPECT_GT(sampler.density_per_sr(left), 0.0) << "only aim() looks at the file";
  sampler.aim(aim);
  EXPECT_EQ(sampler.density_per_sr(left), 0.0);
  EXPECT_GT(sampler.density_per_sr(right), 0.0);
}

TEST_F(Mask, WhatCannotBeReadLeavesTheLastGoodOne) {
  paint(right_half);
  std::string whole;
  {
    std::ostringstream bytes;
    bytes << std::ifstream(path_, std::ios::binary).rdbuf();
    whole = bytes.str();
  }
  paint(left_half);
  MaskSampler sampler(path_, 0.0);
  const auto expect_left = [&](const char* why) {
    sampler.aim(aim);
    EXPECT_GT(sampler.density_per_sr(left), 0.0) << why;
    EXPECT_EQ(sampler.density_per_sr(right), 0.0) << why;
  };
  write(whole.substr(0, whole.size() / 2));
  expect_left("half-written");
  write("no image");
  expect_left("something else");
  paint([](double, double) { return 0.0; });
  expect_left("black");
  std::filesystem::remove(path_);
  expect_left("gone");
  write(whole);
  sampler.aim(aim);
  EXPECT_GT(sampler.density_per_sr(right), 0.0);
}

TEST_F(Mask, RefusesWhatIsNoWeight) {
  EXPECT_THAT(complaint(), HasSubstr("no such file"));
  paint([](double, double) { return 0.0; });
  EXPECT_THAT(complaint(), HasSubstr("black all over"));
  paint([](double x, double y) { return x > 0.9 && y < 0.2 ? -1.0 : 1.0; });
  EXPECT_THAT(complaint(), HasSubstr("pixel (7, 0) has the luminance -1"));
  paint([](double x, double) { return x < 0.1 ? std::numeric_limits<double>::quiet_NaN() : 1.0; });
  EXPECT_THAT(complaint(), HasSubstr("pixel (0, 0) has the luminance nan"));
  paint([](double x, double) { return x < 0.1 ? std::numeric_limits<double>::infinity() : 1.0; });
  EXPECT_THAT(complaint(), HasSubstr("luminance inf"));
}

TEST_F(Mask, RefusesMoreThan64Megapixels) {
  path_ = folder_ / "large.pgm";
  const std::string header = "P5\n9000 9000\n255\n";
  write(header);
  std::filesystem::resize_file(path_, header.size() + std::size_t{9000} * 9000);
  EXPECT_THAT(complaint(), HasSubstr("9000 x 9000 pixels are too many"));
}

}  // namespace
}  // namespace foveola
