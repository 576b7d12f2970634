#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/scene/environment.h"

namespace foveola {
namespace {

using std::numbers::pi;

void require_valid(const SunAndSky& s) {
  const auto require = [](bool is_valid, const char* what, const char* range) {
    if (!is_valid) {
      throw Error("sky", fmt::format("the {} is out of range", what), range);
    }
  };
  require(std::isfinite(s.sun.azimuth_rad), "sun's azimuth", "give an angle");
  require(std::abs(s.sun.elevation_rad) <= 0.5 * pi, "sun's elevation",
          "it lies between -90 and 90 degrees");
  require(s.turbidity >= 2.0 && s.turbidity <= 10.0, "turbidity",
          "it lies between 2 (very clear) and 10 (hazy)");
  require(s.ground_albedo >= 0.0F && s.ground_albedo <= 1.0F, "ground's albedo",
          "it lies between 0 and 1");
}

/// From CIE XYZ to linear Rec. 709 (ITU-R BT.709-6, white D65); colours outside are clipped.
Rgb rgb_from_xyz(const DVec3& xyz) {
  const DVec3 rgb(3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
                  -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
                  0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z);
  return Rgb(glm::max(rgb, DVec3(0.0)));
}

/// The distribution of Perez et al. 1993 for one of Y, x and y (equation 3).
struct Perez {
  double a, b, c, d, e;

  double operator()(double cos_zenith_angle, double angle_to_sun) const {
    const double cosine = std::cos(angle_to_sun);
    return (1.0 + a * std::exp(b / cos_zenith_angle)) *
           (1.0 + c * std::exp(d * angle_to_sun) + e * cosine * cosine);
  }
};

/// Rows are for the turbidity's square, itself and 1; columns for the cube, square, first power of
/// the sun's zenith angle and 1.
using ZenithMatrix = std::array<std::array<double, 4>, 3>;

double zenith_chromaticity(const ZenithMatrix& matrix, double turbidity, double t) {
  double sum = 0.0;
  for (const std::array<double, 4>& row : matrix) {
    sum = sum * turbidity + ((row[0] * t + row[1]) * t + row[2]) * t + row[3];
  }
  return sum;
}

class ClearSky {
 public:
  ClearSky(double sun_elevation_rad, double turbidity)
      : sun_zenith_angle_(0.5 * pi - std::max(sun_elevation_rad, 0.0)),
        dimming_(std::pow(10.0, degrees(std::min(sun_elevation_rad, 0.0)) / 3.0)) {
    const double t = turbidity;
    luminance_ = {.a = 0.1787 * t - 1.4630,
                  .b = -0.3554 * t + 0.4275,
                  .c = -0.0227 * t + 5.3251,
                  .d = 0.1206 * t - 2.5771,
                  .e = -0.0670 * t + 0.3703};
    x_ = {.a = -0.0193 * t - 0.2592,
          .b = -0.0665 * t + 0.0008,
          .c = -0.0004 * t + 0.2125,
          .d = -0.0641 * t - 0.8989,
          .e = -0.0033 * t + 0.0452};
    y_ = {.a = -0.0167 * t - 0.2608,
          .b = -0.0950 * t + 0.0092,
          .c = -0.0079 * t + 0.2102,
          .d = -0.0441 * t - 1.6537,
          .e = -0.0109 * t + 0.0529};
    const double chi = (4.0 / 9.0 - t / 120.0) * (pi - 2.0 * sun_zenith_angle_);
    zenith_luminance_ = (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192;
    zenith_x_ = zenith_chromaticity({{{0.00166, -0.00375, 0.00209, 0.0},
                                      {-0.02903, 0.06377, -0.03202, 0.00394},
                                      {0.11693, -0.21196, 0.06052, 0.25886}}},
                                    t, sun_zenith_angle_);
    zenith_y_ = zenith_chromaticity({{{0.00275, -0.00610, 0.00317, 0.0},
                                      {-0.04214, 0.08970, -0.04153, 0.00516},
                                      {0.15346, -0.26756, 0.06670, 0.26688}}},
                                    t, sun_zenith_angle_);
  }

  /// Equation 4 for each of Y, x and y. The direction lies above the horizon.
  Rgb radiance(double cos_zenith_angle, double angle_to_sun) const {
    const auto relative = [&](const Perez& perez) {
      return perez(cos_zenith_angle, angle_to_sun) / perez(1.0, sun_zenith_angle_);
    };
    const double luminance = dimming_ * zenith_luminance_ * relative(luminance_);
    const double x = zenith_x_ * relative(x_);
    const double y = zenith_y_ * relative(y_);
    return rgb_from_xyz(luminance / y * DVec3(x, y, 1.0 - x - y));
  }

 private:
  double sun_zenith_angle_;  ///< at most a right angle
  double dimming_;           ///< for a sun below the horizon
  Perez luminance_{};
  Perez x_{};
  Perez y_{};
  double zenith_luminance_;  ///< 1000 cd/m^2
  double zenith_x_;
  double zenith_y_;
};

/// The colour matching functions (Wyman, Sloan and Shirley 2013, "Simple Analytic Approximations
/// to the CIE XYZ Color Matching Functions", equation 4).
DVec3 cie_xyz(double wavelength_nm) {
  const auto lobe = [&](double peak, double width_below, double width_above) {
    const double distance = wavelength_nm - peak;
    const double t = distance / (distance < 0.0 ? width_below : width_above);
    return std::exp(-0.5 * t * t);
  };
  return {1.056 * lobe(599.8, 37.9, 31.0) + 0.362 * lobe(442.0, 16.0, 26.7) -
              0.065 * lobe(501.1, 20.4, 26.2),
          0.821 * lobe(568.8, 46.9, 40.5) + 0.286 * lobe(530.9, 16.3, 31.1),
          1.217 * lobe(437.0, 11.8, 36.0) + 0.681 * lobe(459.0, 26.0, 13.8)};
}

constexpr int bands = 38;  ///< each 10 nm wide, from 380 nm on

/// The sun's spectral radiance outside the atmosphere, in 100 W m^-2 sr^-1 nm^-1 (table 2).
constexpr std::array<double, bands> sun_radiance = {
    165.5, 162.3, 211.2, 258.8, 258.2, 242.3, 267.6, 296.6, 305.4, 300.6, 306.6, 288.3, 287.1,
    278.2, 271.0, 272.3, 263.6, 255.0, 250.6, 253.1, 253.5, 251.3, 246.3, 241.7, 236.8, 232.1,
    228.2, 223.4, 219.7, 215.3, 211.0, 207.3, 202.4, 198.7, 194.3, 190.7, 186.3, 182.6};

/// The absorption coefficient of ozone, per centimetre (table 2).
constexpr std::array<double, bands> ozone = {
    0.0,   0.0,   0.0,   0.0,   0.0,   0.0,   0.003, 0.003, 0.006, 0.009, 0.014, 0.021, 0.03,
    0.04,  0.048, 0.063, 0.075, 0.085, 0.103, 0.12,  0.12,  0.115, 0.125, 0.12,  0.105, 0.09,
    0.079, 0.067, 0.057, 0.048, 0.036, 0.028, 0.023, 0.018, 0.014, 0.011, 0.01,  0.009};

/// The sun's normal irradiance.
Rgb sun_irradiance(double elevation_rad, double turbidity) {
  const double zenith_angle = 0.5 * pi - elevation_rad;
  const double air_mass =
      1.0 / (std::cos(zenith_angle) + 0.15 * std::pow(93.885 - degrees(zenith_angle), -1.253));
  const double haze = 0.04608 * turbidity - 0.04586;
  constexpr double ozone_cm = 0.35;
  constexpr double lumens_per_watt = 683.0;
  const double solid_angle = pi * solar_angular_radius_rad * solar_angular_radius_rad;
  DVec3 xyz(0.0);
  for (std::size_t i = 0; i < bands; ++i) {
    const double wavelength_nm = 380.0 + 10.0 * static_cast<double>(i);
    const double wavelength_um = 1e-3 * wavelength_nm;
    const double depth = 0.008735 * std::pow(wavelength_um, -4.08) +
                         haze * std::pow(wavelength_um, -1.3) + ozone_cm * ozone[i];
    const double irradiance = 100.0 * sun_radiance[i] * solid_angle * std::exp(-depth * air_mass);
    xyz += 10.0 * irradiance * cie_xyz(wavelength_nm);
  }
  return rgb_from_xyz(1e-3 * lumens_per_watt * xyz);
}

}  // namespace

Environment sky_environment(const SunAndSky& sun_and_sky) {
  require_valid(sun_and_sky);
  constexpr int width = 1024;
  constexpr int height = 512;
  const ClearSky sky(sun_and_sky.sun.elevation_rad, sun_and_sky.turbidity);
  const Vec3 towards_sun =
      direction_from({.azimuth_rad = sun_and_sky.sun.azimuth_rad,
                      .elevation_rad = std::max(sun_and_sky.sun.elevation_rad, 0.0)});
  Environment environment;
  environment.map_width = width;
  environment.map_height = height;
  environment.map.reserve(std::size_t{width} * height);
  DVec3 irradiance(0.0);  // of the ground
  for (int row = 0; row < height / 2; ++row) {
    const double elevation = (0.5 - (row + 0.5) / height) * pi;
    const double sine = std::sin(elevation);
    const double solid_angle = std::cos(elevation) * (pi / height) * (2.0 * pi / width);
    for (int column = 0; column < width; ++column) {
      const double azimuth = ((column + 0.5) / width - 0.5) * 2.0 * pi;
      const Vec3 direction = direction_from({.azimuth_rad = azimuth, .elevation_rad = elevation});
      const Rgb radiance = sky.radiance(sine, angle_between(direction, towards_sun));
      irradiance += solid_angle * sine * DVec3(radiance);
      environment.map.push_back(radiance);
    }
  }
  if (const std::optional<PunctualLight> sun = sun_light(sun_and_sky)) {
    irradiance += std::sin(sun_and_sky.sun.elevation_rad) * DVec3(sun->intensity);
  }
  const Rgb ground(static_cast<double>(sun_and_sky.ground_albedo) / pi * irradiance);
  environment.map.resize(std::size_t{width} * height, ground);
  return environment;
}

std::optional<PunctualLight> sun_light(const SunAndSky& sun_and_sky) {
  require_valid(sun_and_sky);
  if (sun_and_sky.sun.elevation_rad <= 0.0) {
    return std::nullopt;
  }
  PunctualLight sun;
  sun.name = "sun";
  sun.kind = PunctualLight::Kind::directional;
  sun.direction = -direction_from(sun_and_sky.sun);
  sun.intensity = sun_irradiance(sun_and_sky.sun.elevation_rad, sun_and_sky.turbidity);
  sun.angular_radius_rad = static_cast<float>(solar_angular_radius_rad);
  return sun;
}

}  // namespace foveola
