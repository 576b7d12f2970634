// Panoramas of spherical harmonics, seen through every kind of viewport. What each pixel must show
// is worked out here in double, from angles and closed forms alone.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>

#include <gtest/gtest.h>

#include "renderer/film/viewport_resampler.h"

namespace foveola {
namespace {

constexpr int harmonics_width = 1024;
constexpr int harmonics_height = 512;
constexpr int viewport_width = 240;
constexpr int viewport_height = 200;
using std::numbers::pi;

/// Real spherical harmonics of degrees 1 to 3 of a unit vector, without their constants (Sloan
/// 2008, "Stupid Spherical Harmonics (SH) Tricks", appendix A2), brought to about [0, 1].
Rgb harmonics(const DVec3& d) {
  const double degree_1 = d.x;
  const double degree_2 = 3.0 * d.y * d.y - 1.0 + 2.0 * d.x * d.z;
  const double degree_3 = d.y * (5.0 * d.y * d.y - 3.0) + d.x * (d.x * d.x - 3.0 * d.z * d.z);
  return {static_cast<float>(0.5 + 0.5 * degree_1), static_cast<float>(0.5 + 0.2 * degree_2),
          static_cast<float>(0.5 + 0.2 * degree_3)};
}

DVec3 direction_of(double azimuth_rad, double elevation_rad) {
  return {std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad),
          -std::cos(elevation_rad) * std::cos(azimuth_rad)};
}

/// What the middle of a film's pixel shows.
Rgb color_of_pixel(int x, int y) {
  return harmonics(direction_of(((x + 0.5) / harmonics_width - 0.5) * 2.0 * pi,
                                (0.5 - (y + 0.5) / harmonics_height) * pi));
}

const RgbImage& panorama() {
  static const RgbImage image = [] {
    RgbImage made(harmonics_width, harmonics_height);
    for (int y = 0; y < harmonics_height; ++y) {
      for (int x = 0; x < harmonics_width; ++x) {
        made.at(x, y) = color_of_pixel(x, y);
      }
    }
    return made;
  }();
  return image;
}

/// One sample in the middle of each pixel.
const EquirectFilm& sampled_film() {
  static const std::unique_ptr<const EquirectFilm> film = [] {
    auto made = std::make_unique<EquirectFilm>(harmonics_width, harmonics_height);
    std::vector<ViewSample> samples;
    for (int y = 0; y < harmonics_height; ++y) {
      for (int x = 0; x < harmonics_width; ++x) {
        samples.push_back({.direction = {0.0F, 0.0F, -1.0F},
                           .image = {static_cast<float>(x + 0.5) / harmonics_width,
                                     static_cast<float>(y + 0.5) / harmonics_height}});
      }
    }
    const Workers workers(1);
    NumberedBatch batch;
    made->number(samples, batch, workers);
    std::vector<Rgb> radiance;
    for (const SampleJob& job : batch.jobs) {
      radiance.push_back(color_of_pixel(static_cast<int>(job.pixel) % harmonics_width,
                                        static_cast<int>(job.pixel) / harmonics_width));
    }
    made->add(batch, radiance, workers);
    return made;
  }();
  return *film;
}

struct Pose {
  double azimuth_deg;
  double elevation_deg;
  double roll_deg;  ///< roll of the head towards its left shoulder
};

std::ostream& operator<<(std::ostream& out, const Pose& pose) {
  return out << pose.azimuth_deg << ", " << pose.elevation_deg << ", rolled " << pose.roll_deg;
}

/// Right, up and ahead of a head.
struct Axes {
  DVec3 right;
  DVec3 up;
  DVec3 ahead;
};

Axes axes_of(const Pose& pose) {
  const double azimuth = pose.azimuth_deg * pi / 180.0;
  const double elevation = pose.elevation_deg * pi / 180.0;
  const double roll = pose.roll_deg * pi / 180.0;
  const DVec3 level_right(std::cos(azimuth), 0.0, std::sin(azimuth));
  const DVec3 level_up = direction_of(azimuth, elevation + pi / 2.0);
  return {std::cos(roll) * level_right + std::sin(roll) * level_up,
          std::cos(roll) * level_up - std::sin(roll) * level_right,
          direction_of(azimuth, elevation)};
}

/// The rotation that takes the head's right, up and back to `axes`.
Quat orientation_of(const Axes& axes) {
  return Quat(glm::quat_cast(glm::dmat3(axes.right, axes.up, -axes.ahead)));
}

/// A display, and what its lens does.
struct Display {
  double horizontal_fov_deg;
  double vertical_fov_deg;
  RadialLens lens;
};

/// What the middle of a pixel of the view shows.
Rgb expected_color(const Axes& axes, const Display& display, int x, int y) {
  const double right = 2.0 * ((x + 0.5) / viewport_width - display.lens.axis.x) *
                       std::tan(display.horizontal_fov_deg * pi / 360.0);
  const double down = 2.0 * ((y + 0.5) / viewport_height - display.lens.axis.y) *
                      std::tan(display.vertical_fov_deg * pi / 360.0);
  const double d2 = right * right + down * down;
  const double larger = 1.0 + display.lens.k1 * d2 + display.lens.k2 * d2 * d2;
  return harmonics(
      glm::normalize(axes.ahead + larger * right * axes.right - larger * down * axes.up));
}

using Show = std::function<RgbImage(const Viewport& viewport)>;

class Harmonics : public testing::TestWithParam<Pose> {
 protected:
  /// The largest error of what `show` shows, over the colours of all pixels.
  static double largest_error(const Display& display, const Show& show) {
    const Axes axes = axes_of(GetParam());
    const RgbImage view =
        show(Viewport(orientation_of(axes), display.horizontal_fov_deg * pi / 180.0,
                      display.vertical_fov_deg * pi / 180.0, display.lens));
    double largest = 0.0;
    for (int y = 0; y < viewport_height; ++y) {
      for (int x = 0; x < viewport_width; ++x) {
        const Rgb error = glm::abs(view.at(x, y) - expected_color(axes, display, x, y));
        largest = std::max<double>(largest, std::max({error.r, error.g, error.b}));
      }
    }
    return largest;
  }
};

constexpr RadialLens left_eye{.axis = {0.56F, 0.5F}, .k1 = 0.22F, .k2 = 0.24F};
constexpr RadialLens right_eye{.axis = {0.44F, 0.5F}, .k1 = 0.22F, .k2 = 0.24F};

TEST_P(Harmonics, AreShownAsTheyAre) {
  for (const Display& display :
       {Display{20.0, 15.0, {}}, Display{60.0, 60.0, {}}, Display{100.0, 85.0, {}},
        Display{125.0, 110.0, {}}, Display{70.0, 80.0, left_eye}, Display{70.0, 80.0, right_eye},
        Display{100.0, 100.0, left_eye}, Display{100.0, 100.0, right_eye}}) {
    const auto of_film = [](const Viewport& viewport) {
      return viewport_image(sampled_film(), viewport, viewport_width, viewport_height,
                            UnsampledPixels::black, Workers(1));
    };
    const auto of_panorama = [](const Viewport& viewport) {
      return viewport_image(panorama(), viewport, viewport_width, viewport_height);
    };
    SCOPED_TRACE(testing::Message() << display.horizontal_fov_deg << " degrees, lens axis "
                                    << display.lens.axis.x << ", k1 " << display.lens.k1);
    EXPECT_LT(largest_error(display, of_film), 1e-3);
    EXPECT_LT(largest_error(display, of_panorama), 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Poses, Harmonics,
                         testing::Values(Pose{0.0, 0.0, 0.0}, Pose{37.0, 20.0, 0.0},
                                         Pose{180.0, 0.0, 0.0}, Pose{179.9, -35.0, 25.0},
                                         Pose{-179.5, 60.0, -140.0}, Pose{-90.0, 0.0, 90.0},
                                         Pose{0.0, 90.0, 0.0}, Pose{130.0, 89.8, 200.0},
                                         Pose{-77.0, -90.0, 45.0}, Pose{15.0, -70.0, -60.0},
                                         Pose{100.0, 45.0, 180.0}, Pose{-33.0, -12.0, -90.0}));

// A head without a roll is what everything else calls a heading.
TEST(HeadOrientation, IsAPoseWithoutARoll) {
  for (const Pose& pose : {Pose{0.0, 0.0, 0.0}, Pose{37.0, 20.0, 0.0}, Pose{-150.0, -80.0, 0.0}}) {
    const Quat head = head_orientation({.azimuth_rad = pose.azimuth_deg * pi / 180.0,
                                        .elevation_rad = pose.elevation_deg * pi / 180.0});
    const Axes axes = axes_of(pose);
    EXPECT_LT(glm::distance(head * Vec3(1, 0, 0), Vec3(axes.right)), 1e-6F) << pose;
    EXPECT_LT(glm::distance(head * Vec3(0, 1, 0), Vec3(axes.up)), 1e-6F) << pose;
    EXPECT_LT(glm::distance(head * Vec3(0, 0, -1), Vec3(axes.ahead)), 1e-6F) << pose;
  }
}

}  // namespace
}  // namespace foveola
