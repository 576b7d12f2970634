// How many samples a square degree gets, counted in rings around the gaze, against quadratures of
// the published formulas.
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/base/random.h"
#include "renderer/view/view_sampler.h"

namespace foveola {
namespace {

constexpr double pi = std::numbers::pi;

constexpr AzimuthElevation head{.azimuth_rad = radians(30.0), .elevation_rad = radians(20.0)};
constexpr AzimuthElevation gaze{.azimuth_rad = radians(38.0), .elevation_rad = radians(14.0)};
constexpr double view_width_deg = 100.0;
constexpr double view_height_deg = 80.0;

std::vector<double> counts(const std::string& method, std::span<const double> ends_deg) {
  constexpr std::uint64_t samples_in_all = 1 << 20;
  constexpr std::size_t batch = 1 << 14;
  const auto sampler = make_view_sampler(method);
  const Vec3 middle = direction_from(gaze);
  sampler->aim({.viewport = Viewport(head_orientation(head), radians(view_width_deg),
                                     radians(view_height_deg)),
                .gaze = middle});
  std::vector<double> cosines;
  for (const double end_deg : ends_deg) {
    cosines.push_back(std::cos(radians(end_deg)));
  }
  std::vector<double> fractions(ends_deg.size() - 1);
  std::vector<Vec2> points(batch);
  std::vector<ViewSample> samples(batch);
  for (std::uint64_t first = 0; first < samples_in_all; first += batch) {
    for (std::size_t i = 0; i < batch; ++i) {
      points[i] = sobol_2d(first + i, 7);
    }
    sampler->sample(points, samples);
    for (const ViewSample& sample : samples) {
      const double cosine = glm::dot(DVec3(sample.direction), DVec3(middle));
      for (std::size_t ring = 0; ring < fractions.size(); ++ring) {
        fractions[ring] += cosine <= cosines[ring] && cosine > cosines[ring + 1] ? 1.0 : 0.0;
      }
    }
  }
  for (double& fraction : fractions) {
    fraction /= static_cast<double>(samples_in_all);
  }
  return fractions;
}

/// Of a function of eccentricity (degrees) and azimuth around the gaze (radians, from the right
/// towards up), by the midpoint rule.
double ring_integral(double begin_deg, double end_deg, int sectors,
                     const std::function<double(double e, double azimuth)>& f) {
  constexpr int steps = 400;
  const double step = (end_deg - begin_deg) / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < sectors; ++j) {
      sum += f(begin_deg + (i + 0.5) * step, 2.0 * pi * (j + 0.5) / sectors);
    }
  }
  return sum * step * 2.0 * pi / sectors;
}

void expect_counts(const std::string& method, std::span<const double> ends_deg,
                   const std::function<double(std::size_t ring)>& expected) {
  const std::vector<double> found = counts(method, ends_deg);
  for (std::size_t ring = 0; ring < found.size(); ++ring) {
    const double area = 2.0 * pi * degrees(1.0) * degrees(1.0) *
                        (std::cos(radians(ends_deg[ring])) - std::cos(radians(ends_deg[ring + 1])));
    EXPECT_NEAR(found[ring] / expected(ring), 1.0, 0.01)
        << method << " from " << ends_deg[ring] << " to " << ends_deg[ring + 1]
        << " degrees: " << 1e6 * found[ring] / area << " of a million samples a square degree";
  }
}

/// The true density per steradian of a direction at an eccentricity and azimuth, over a ring.
double ring_share(double begin_deg, double end_deg,
                  const std::function<double(const DVec3&)>& density_per_sr) {
  const DVec3 ahead(direction_from(gaze));
  const DVec3 right = glm::normalize(glm::cross(ahead, DVec3(0.0, 1.0, 0.0)));
  const DVec3 up = glm::cross(right, ahead);
  return radians(1.0) * ring_integral(begin_deg, end_deg, 800, [&](double e, double azimuth) {
           const double sine = std::sin(radians(e));
           return sine *
                  density_per_sr(std::cos(radians(e)) * ahead + sine * std::cos(azimuth) * right +
                                 sine * std::sin(azimuth) * up);
         });
}

constexpr double wide_rings_deg[] = {0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0};

// Uniform over the image: 1 / (2 pi^2 cos(elevation)) a steradian.
TEST(MeanDensity, OdIsUniformOverTheImage) {
  expect_counts("od", wide_rings_deg, [](std::size_t ring) {
    return ring_share(wide_rings_deg[ring], wide_rings_deg[ring + 1], [](const DVec3& d) {
      return 1.0 / (2.0 * pi * pi * std::sqrt(1.0 - d.y * d.y));
    });
  });
}

// Uniform over the plane at distance 1: 1 / (area cos^3) a steradian. The last ring is outside.
TEST(MeanDensity, VpIsUniformOverThePlane) {
  const DVec3 ahead(direction_from(head));
  const DVec3 right = glm::normalize(glm::cross(ahead, DVec3(0.0, 1.0, 0.0)));
  const DVec3 up = glm::cross(right, ahead);
  const double half_width = std::tan(radians(0.5 * view_width_deg));
  const double half_height = std::tan(radians(0.5 * view_height_deg));
  const std::span<const double> rings = std::span(wide_rings_deg).first(7);
  expect_counts("vp", rings, [&](std::size_t ring) {
    return ring_share(rings[ring], rings[ring + 1], [&](const DVec3& d) {
      const double cosine = glm::dot(d, ahead);
      const bool is_inside = cosine > 0.0 && std::abs(glm::dot(d, right)) < half_width * cosine &&
                             std::abs(glm::dot(d, up)) < half_height * cosine;
      return is_inside ? 1.0 / (4.0 * half_width * half_height * std::pow(cosine, 3)) : 0.0;
    });
  });
}

/// Relative samples per planar square degree.
struct Model {
  const char* method;
  std::function<double(double e, double azimuth)> density;
  int sectors = 1;  ///< that its quadrature needs
};

double reddy(double e) { return e <= 5.79 ? 1.0 : 7.49 / std::pow(0.3 * e + 1.0, 2); }

double linear(double e, double inner, double outer, double least) {
  const double t = (e - inner) / (outer - inner);
  return t <= 0.0 ? 1.0 : t >= 1.0 ? least : 1.0 + t * (least - 1.0);
}

/// Watson 2014, eq. 8, on the meridian k of table 1.
double watson_meridian(int k, double r) {
  const double a[] = {0.9851, 0.9935, 0.9729, 0.996};
  const double r2[] = {1.058, 1.035, 1.084, 0.9932};
  const double re[] = {22.14, 16.35, 7.633, 12.13};
  return (a[k] * std::pow(1.0 + r / r2[k], -2.0) + (1.0 - a[k]) * std::exp(-r / re[k])) /
         (1.0 + r / 41.03);
}

/// The right eye's field, with density between the meridians as the square of an ellipse's inverse
/// radius.
double watson(double r, double azimuth) {
  const double x = std::cos(azimuth);
  const double y = std::sin(azimuth);
  return 1.0 / (x * x / watson_meridian(x > 0.0 ? 0 : 2, r) +
                y * y / watson_meridian(y > 0.0 ? 3 : 1, r));
}

class FoveatedMeanDensity : public testing::TestWithParam<int> {};

const std::array<Model, 10>& models() {
  static const std::array<Model, 10> all{{
      {"fv", [](double e, double) { return reddy(e); }},
      {"fv:exponent=2", [](double e, double) { return std::pow(reddy(e), 2); }},
      {"fv:measure=solid-angle",
       [](double e, double) { return reddy(e) * std::sin(radians(e)) / radians(e); }},
      {"fv:acuity=guenter", [](double e, double) { return std::pow(1.0 + 48.0 * 0.022 * e, -2); }},
      {"fv:acuity=linear", [](double e, double) { return linear(e, 10.0, 20.0, 0.05); }},
      {"fv:acuity=weier1", [](double e, double) { return linear(e, 5.0, 10.0, 0.01); }},
      {"fv:acuity=weier2", [](double e, double) { return linear(e, 10.0, 20.0, 0.05); }},
      {"fv:acuity=weier3", [](double e, double) { return linear(e, 15.0, 30.0, 0.1); }},
      {"fv:acuity=watson,eye=right", watson, 200},
      {"pointer", [](double e, double) { return std::exp(-0.5 * e * e / 100.0); }},
  }};
  return all;
}

constexpr double narrow_rings_deg[] = {0.0, 1.0, 2.0, 5.0, 5.79, 10.0, 15.0, 20.0, 30.0, 45.0};

TEST_P(FoveatedMeanDensity, IsThePublishedOne) {
  const Model& model = models()[static_cast<std::size_t>(GetParam())];
  const auto weight = [&](double e, double azimuth) { return e * model.density(e, azimuth); };
  std::vector<double> masses;
  double total = ring_integral(45.0, 80.0, model.sectors, weight);
  for (std::size_t ring = 0; ring + 1 < std::size(narrow_rings_deg); ++ring) {
    masses.push_back(
        ring_integral(narrow_rings_deg[ring], narrow_rings_deg[ring + 1], model.sectors, weight));
    total += masses.back();
  }
  expect_counts(model.method, narrow_rings_deg,
                [&](std::size_t ring) { return masses[ring] / total; });
}

INSTANTIATE_TEST_SUITE_P(Models, FoveatedMeanDensity, testing::Range(0, 10));

}  // namespace
}  // namespace foveola
