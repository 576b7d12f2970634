#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "renderer/scene/environment.h"

namespace foveola {
namespace {

using std::numbers::pi;

SunAndSky daylight(double elevation_deg, double turbidity = 3.0, double azimuth_deg = 0.0) {
  return {.sun = {.azimuth_rad = radians(azimuth_deg), .elevation_rad = radians(elevation_deg)},
          .turbidity = turbidity};
}

Rgb texel_at(const Environment& sky, double azimuth_deg, double elevation_deg) {
  const auto column = static_cast<std::size_t>((azimuth_deg / 360.0 + 0.5) * sky.map_width);
  const auto row = static_cast<std::size_t>((0.5 - elevation_deg / 180.0) * sky.map_height);
  return sky.map[row * static_cast<std::size_t>(sky.map_width) + column];
}

/// Onto the ground, in 1000 lx.
double horizontal_illuminance(const Environment& sky) {
  double sum = 0.0;
  for (int row = 0; row < sky.map_height / 2; ++row) {
    const double elevation = (0.5 - (row + 0.5) / sky.map_height) * pi;
    const double weight = std::sin(elevation) * std::cos(elevation) * (pi / sky.map_height) *
                          (2.0 * pi / sky.map_width);
    for (int column = 0; column < sky.map_width; ++column) {
      sum += weight * luminance(sky.map[static_cast<std::size_t>(row * sky.map_width + column)]);
    }
  }
  return sum;
}

/// The paper's formula by hand for turbidity 3 and a sun at 45 degrees: chi = 0.65886,
/// Y = (12.1359 - 4.9710) tan(chi) - 0.6465 + 2.4192 = 7.3212.
TEST(Sky, ZenithHasThePapersLuminance) {
  const Environment sky = sky_environment(daylight(45.0));
  EXPECT_EQ(sky.map_width, 1024);
  EXPECT_EQ(sky.map_height, 512);
  EXPECT_EQ(sky.radiance, Rgb(1.0F));
  EXPECT_NEAR(luminance(texel_at(sky, 0.0, 89.9)), 7.32, 0.05);
}

/// Zenith chromaticity by hand for turbidity 2 and a sun in the zenith (only the matrices' last
/// column counts): x = 2 * 0.00394 + 0.25886 = 0.26674, y = 2 * 0.00516 + 0.26688 = 0.27720; its
/// Rec. 709 ratios from the standard's matrix.
TEST(Sky, ZenithHasThePapersColour) {
  const Rgb zenith = texel_at(sky_environment(daylight(90.0, 2.0)), 0.0, 89.9);
  const double x = 0.26674 / 0.27720;
  const double z = (1.0 - 0.26674 - 0.27720) / 0.27720;
  const double red = 3.2404542 * x - 1.5371385 - 0.4985314 * z;
  const double green = -0.9692660 * x + 1.8760108 + 0.0415560 * z;
  const double blue = 0.0556434 * x - 0.2040259 + 1.0572252 * z;
  EXPECT_NEAR(zenith.r / zenith.g, red / green, 0.01);
  EXPECT_NEAR(zenith.b / zenith.g, blue / green, 0.01);
}

/// Clear skies with the sun at 60 degrees give 10 to 25 thousand lux (IES Lighting Handbook).
TEST(Sky, IlluminanceIsThatOfDaylight) {
  const double noon = horizontal_illuminance(sky_environment(daylight(60.0, 2.5)));
  EXPECT_GT(noon, 8.0);
  EXPECT_LT(noon, 30.0);
}

TEST(Sky, IsBrightestAroundTheSunWhereverItStands) {
  for (const double azimuth_deg : {-120.0, 0.0, 90.0}) {
    const Environment sky = sky_environment(daylight(40.0, 3.0, azimuth_deg));
    const float around_sun = luminance(texel_at(sky, azimuth_deg, 40.0));
    const double opposite = azimuth_deg > 0.0 ? azimuth_deg - 180.0 : azimuth_deg + 179.0;
    EXPECT_GT(around_sun, 3.0F * luminance(texel_at(sky, opposite, 40.0)));
    EXPECT_GT(around_sun, luminance(texel_at(sky, azimuth_deg, 70.0)));
  }
}

TEST(Sky, GroundReflectsSkyAndSun) {
  SunAndSky lit = daylight(30.0);
  lit.ground_albedo = 0.5F;
  const Environment sky = sky_environment(lit);
  const double sun = std::sin(radians(30.0)) * luminance(sun_light(lit).value().intensity);
  const double expected = 0.5 * (horizontal_illuminance(sky) + sun) / pi;
  EXPECT_NEAR(luminance(texel_at(sky, 10.0, -45.0)), expected, 1e-3 * expected);
  lit.ground_albedo = 0.0F;
  EXPECT_EQ(texel_at(sky_environment(lit), 10.0, -45.0), Rgb(0.0F));
}

TEST(Sky, IsFiniteAndNeverNegativeWhereverTheSunStands) {
  for (const double elevation_deg : {-90.0, -30.0, -6.0, -0.01, 0.0, 0.01, 1.0, 30.0, 89.9, 90.0}) {
    for (const double turbidity : {2.0, 5.0, 10.0}) {
      const Environment sky = sky_environment(daylight(elevation_deg, turbidity));
      for (const Rgb& texel : sky.map) {
        ASSERT_TRUE(is_finite(texel)) << elevation_deg << " " << turbidity;
        ASSERT_GE(glm::min(texel.r, glm::min(texel.g, texel.b)), 0.0F);
      }
    }
  }
}

TEST(Sky, DarkensAsTheSunSinks) {
  double before = std::numeric_limits<double>::infinity();
  for (const double elevation_deg : {20.0, 5.0, 0.0, -3.0, -6.0, -12.0}) {
    const double now = horizontal_illuminance(sky_environment(daylight(elevation_deg)));
    EXPECT_LT(now, before) << elevation_deg;
    before = now;
  }
  const double sunset = horizontal_illuminance(sky_environment(daylight(0.0)));
  EXPECT_NEAR(horizontal_illuminance(sky_environment(daylight(-6.0))), 0.01 * sunset,
              1e-6 * sunset);
}

/// The sun outside of the atmosphere gives 128 to 134 thousand lux; through a clear one in the
/// zenith some 100 to 115 remain.
TEST(Sun, IlluminanceIsThatOfTheSun) {
  EXPECT_GT(luminance(sun_light(daylight(90.0, 2.0)).value().intensity), 95.0F);
  EXPECT_LT(luminance(sun_light(daylight(90.0, 2.0)).value().intensity), 120.0F);
  EXPECT_LT(luminance(sun_light(daylight(90.0, 6.0)).value().intensity),
            luminance(sun_light(daylight(90.0, 2.0)).value().intensity));
}

TEST(Sun, ReddensAndFadesTowardsTheHorizon) {
  const Rgb high = sun_light(daylight(60.0)).value().intensity;
  const Rgb low = sun_light(daylight(3.0)).value().intensity;
  EXPECT_NEAR(high.b / high.r, 0.8, 0.2) << "near white";
  EXPECT_LT(low.b / low.r, 0.3);
  EXPECT_LT(luminance(low), 0.2F * luminance(high));
  EXPECT_FALSE(sun_light(daylight(0.0)).has_value());
  EXPECT_FALSE(sun_light(daylight(-20.0)).has_value());
}

TEST(Sun, ShinesAwayFromItsPlace) {
  const PunctualLight sun = sun_light(daylight(30.0, 3.0, 90.0)).value();
  EXPECT_EQ(sun.kind, PunctualLight::Kind::directional);
  EXPECT_NEAR(sun.direction.x, -std::cos(radians(30.0)), 1e-6);
  EXPECT_NEAR(sun.direction.y, -0.5, 1e-6);
  EXPECT_NEAR(sun.direction.z, 0.0, 1e-6);
  EXPECT_NEAR(sun.angular_radius_rad, 0.00465, 1e-6);
}

TEST(Sky, RefusesWhatMakesNoSense) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(sky_environment(daylight(91.0)), Error);
  EXPECT_THROW(sky_environment(daylight(nan)), Error);
  EXPECT_THROW(sky_environment(daylight(30.0, 1.5)), Error);
  EXPECT_THROW(sky_environment(daylight(30.0, nan)), Error);
  EXPECT_THROW(sun_light(daylight(30.0, 11.0)), Error);
  EXPECT_THROW(sky_environment(daylight(30.0, 3.0, nan)), Error);
}

}  // namespace
}  // namespace foveola
