// How many samples a square degree gets, counted on the film in rings around the gaze, against
// quadratures of the published formulas.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "renderer/film/sample_pass.h"
#include "renderer/view/equirect.h"
#include "tests/renderer/film/run_pass.h"
#include "tests/renderer/view/test_images.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

using std::numbers::pi;
constexpr int width = 1024;
constexpr int height = 512;

constexpr AzimuthElevation head{.azimuth_rad = radians(30.0), .elevation_rad = radians(20.0)};
constexpr AzimuthElevation gaze{.azimuth_rad = radians(38.0), .elevation_rad = radians(14.0)};
constexpr double view_width_deg = 100.0;
constexpr double view_height_deg = 80.0;

/// A direction as the formulas want it.
struct Seen {
  DVec3 direction;
  double e;        ///< degrees from the gaze
  double azimuth;  ///< around the gaze, from the right towards the head's up
  Vec2 image;
};

/// A relative density per steradian.
using Density = std::function<double(const Seen&)>;

struct Part {
  double share;
  Density density;
};

struct Method {
  const char* text;  ///< MAP and MASK are the images below
  std::vector<Part> parts;
};

class Frames {
 public:
  Frames() {
    head_ahead = DVec3(direction_from(head));
    head_right = glm::normalize(glm::cross(head_ahead, DVec3(0.0, 1.0, 0.0)));
    head_up = glm::cross(head_right, head_ahead);
    gaze_ahead = DVec3(direction_from(gaze));
    gaze_up = glm::normalize(head_up - glm::dot(head_up, gaze_ahead) * gaze_ahead);
    gaze_right = glm::cross(gaze_ahead, gaze_up);
  }
  Seen seen(double u, double v) const {
    const double azimuth = (u - 0.5) * 2.0 * pi;
    const double elevation = (0.5 - v) * pi;
    const DVec3 d(std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                  -std::cos(elevation) * std::cos(azimuth));
    const double x = glm::dot(d, gaze_right);
    const double y = glm::dot(d, gaze_up);
    return {.direction = d,
            .e = degrees(std::atan2(std::hypot(x, y), glm::dot(d, gaze_ahead))),
            .azimuth = std::atan2(y, x),
            .image = Vec2(u, v)};
  }

  DVec3 head_ahead, head_right, head_up;
  DVec3 gaze_ahead, gaze_up, gaze_right;
};

const Frames frames;

/// A density per planar square degree within 80 degrees as one per steradian.
Density planar(const std::function<double(double e, double azimuth)>& density,
               double cutoff_deg = 80.0) {
  return [=](const Seen& s) {
    const double e = radians(std::max(s.e, 1e-6));
    return s.e <= cutoff_deg ? density(s.e, s.azimuth) * e / std::sin(e) : 0.0;
  };
}

double reddy(double e) { return e <= 5.79 ? 1.0 : 7.49 / std::pow(0.3 * e + 1.0, 2); }

/// 1 / (2 pi e p'(u)) of the paper's radius p(u), its equation 7, with u by bisection.
double equation7(double e) {
  if (e <= 18.64 * std::sqrt(0.0965)) {
    return 1.0 / (pi * 18.64 * 18.64);
  }
  const auto radius = [](double u) {
    return (((25.09 * u + 0.1680) * u + 27.61) * u + 23.87) * u + 3.232;
  };
  double low = 0.0965;
  double high = 1.0;
  if (e < radius(low)) {
    return 0.0;
  }
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (radius(middle) < e ? low : high) = middle;
  }
  const double slope = ((100.36 * low + 0.504) * low + 55.22) * low + 23.87;
  return 1.0 / (2.0 * pi * e * slope);
}

Density linear(double inner, double outer, double least) {
  return planar([=](double e, double) {
    const double t = (e - inner) / (outer - inner);
    return t <= 0.0 ? 1.0 : t >= 1.0 ? least : 1.0 + t * (least - 1.0);
  });
}

/// Watson 2014, eq. 8, on the row k of table 1: temporal, superior, nasal, inferior.
double watson_row(int k, double r) {
  const double a[] = {0.9851, 0.9935, 0.9729, 0.996};
  const double r2[] = {1.058, 1.035, 1.084, 0.9932};
  const double re[] = {22.14, 16.35, 7.633, 12.13};
  return (a[k] * std::pow(1.0 + r / r2[k], -2.0) + (1.0 - a[k]) * std::exp(-r / re[k])) /
         (1.0 + r / 41.03);
}

/// An eye's field, with density between the meridians as the square of an ellipse's inverse
/// radius. The superior retina sees the lower field.
double watson(double r, double azimuth, bool is_right) {
  const double x = is_right ? std::cos(azimuth) : -std::cos(azimuth);
  const double y = std::sin(azimuth);
  return 1.0 / (x * x / watson_row(x > 0.0 ? 0 : 2, r) + y * y / watson_row(y > 0.0 ? 3 : 1, r));
}

/// Uniform over the image: its area a steradian is 1 / (2 pi^2 cos(elevation)).
double of_image(const Seen& s) { return 1.0 / std::sqrt(1.0 - s.direction.y * s.direction.y); }

double in_view(const Seen& s) {
  const double z = glm::dot(s.direction, frames.head_ahead);
  const bool is_inside = z > 0.0 &&
                         std::abs(glm::dot(s.direction, frames.head_right)) <
                             std::tan(radians(0.5 * view_width_deg)) * z &&
                         std::abs(glm::dot(s.direction, frames.head_up)) <
                             std::tan(radians(0.5 * view_height_deg)) * z;
  return is_inside ? 1.0 / (z * z * z) : 0.0;
}

/// The image's rectangle around the view, by walking over the whole of the view.
double in_view_rectangle(const Seen& s) {
  struct Rectangle {
    double left = 1.0, right = 0.0, top = 1.0, bottom = 0.0;
  };
  static const Rectangle rectangle = [] {
    Rectangle r;
    for (int i = 0; i <= 400; ++i) {
      for (int j = 0; j <= 400; ++j) {
        const DVec3 d =
            frames.head_ahead +
            (i / 200.0 - 1.0) * std::tan(radians(0.5 * view_width_deg)) * frames.head_right +
            (j / 200.0 - 1.0) * std::tan(radians(0.5 * view_height_deg)) * frames.head_up;
        const double u = 0.5 + std::atan2(d.x, -d.z) / (2.0 * pi);
        const double v = 0.5 - std::asin(d.y / glm::length(d)) / pi;
        r = {std::min(r.left, u), std::max(r.right, u), std::min(r.top, v), std::max(r.bottom, v)};
      }
    }
    return r;
  }();
  const bool is_inside = s.image.x >= rectangle.left && s.image.x <= rectangle.right &&
                         s.image.y >= rectangle.top && s.image.y <= rectangle.bottom;
  return is_inside ? of_image(s) : 0.0;
}

// The crop of 60 x 50 degrees around azimuth 40, elevation 10: image columns and rows.
double in_crop(const Seen& s) {
  const bool is_inside = std::abs(s.image.x - (0.5 + 40.0 / 360.0)) <= 30.0 / 360.0 &&
                         std::abs(s.image.y - (0.5 - 10.0 / 180.0)) <= 25.0 / 180.0;
  return is_inside ? of_image(s) : 0.0;
}

constexpr int weights_width = 16;
constexpr int weights_height = 8;
double painted(double x, double y) { return 0.2 + x * x + (y < 0.5 ? y : 0.1); }

/// The value of the painted pixel at a place in [0, 1)^2.
double painted_pixel(double x, double y) {
  return painted((std::floor(x * weights_width) + 0.5) / weights_width,
                 (std::floor(y * weights_height) + 0.5) / weights_height);
}

double in_mask(const Seen& s) { return of_image(s) * painted_pixel(s.image.x, s.image.y); }

/// The map reaches 60 degrees to the right and left, 30 up and down.
const Density in_map = planar(
    [](double e, double azimuth) {
      const double x = 0.5 + e * std::cos(azimuth) / 120.0;
      const double y = 0.5 - e * std::sin(azimuth) / 60.0;
      const bool is_inside = x >= 0.0 && x < 1.0 && y >= 0.0 && y < 1.0;
      return is_inside ? painted_pixel(x, y) : 0.0;
    },
    179.0);

const Density in_fv = planar([](double e, double) { return reddy(e); });

std::vector<Method> methods() {
  return {
      {"od", {{1.0, of_image}}},
      {"vp", {{1.0, in_view}}},
      {"vp-rect", {{1.0, in_view_rectangle}}},
      {"fv", {{1.0, in_fv}}},
      {"fv-paper", {{1.0, planar([](double e, double) { return equation7(e); }, 79.97)}}},
      {"fv:exponent=2", {{1.0, planar([](double e, double) { return std::pow(reddy(e), 2); })}}},
      {"fv:measure=solid-angle",
       {{1.0, [](const Seen& s) { return s.e <= 80.0 ? reddy(s.e) : 0.0; }}}},
      {"fv:acuity=guenter",
       {{1.0, planar([](double e, double) { return std::pow(1.0 + 48.0 * 0.022 * e, -2); })}}},
      {"fv:acuity=linear", {{1.0, linear(10.0, 20.0, 0.05)}}},
      {"fv:acuity=weier1", {{1.0, linear(5.0, 10.0, 0.01)}}},
      {"fv:acuity=weier2", {{1.0, linear(10.0, 20.0, 0.05)}}},
      {"fv:acuity=weier3", {{1.0, linear(15.0, 30.0, 0.1)}}},
      {"fv:acuity=watson,eye=right",
       {{1.0, planar([](double e, double a) { return watson(e, a, true); })}}},
      {"fv:acuity=watson,eye=left",
       {{1.0, planar([](double e, double a) { return watson(e, a, false); })}}},
      {"fv:acuity=watson", {{1.0, planar([](double e, double a) {
                               return watson(e, a, true) + watson(e, a, false);
                             })}}},
      {"fv-map:file=MAP,extent=60", {{1.0, in_map}}},
      {"mask:file=MASK", {{1.0, in_mask}}},
      {"pointer", {{1.0, planar([](double e, double) { return std::exp(-0.5 * e * e / 100.0); })}}},
      {"crop:azimuth=40,elevation=10,width=60,height=50", {{1.0, in_crop}}},
      {"hybrid:3*fv+1*od", {{0.75, in_fv}, {0.25, of_image}}},
  };
}

constexpr double ring_ends_deg[] = {1.0,  2.0,  5.0,  5.79, 10.0, 15.0, 20.0,
                                    30.0, 40.0, 50.0, 60.0, 80.0, 180.0};
constexpr std::size_t rings = std::size(ring_ends_deg);
using PerRing = std::array<double, rings>;

std::size_t ring_of(double e) {
  const auto* const found = std::lower_bound(ring_ends_deg, ring_ends_deg + rings - 1, e);
  return static_cast<std::size_t>(found - ring_ends_deg);
}

/// The share of samples in the pixels whose middles lie in each ring: of each pixel by midpoints,
/// many where the densities are steep.
PerRing expected_shares(const Density& density) {
  PerRing shares{};
  double total = 0.0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double e = frames.seen((x + 0.5) / width, (y + 0.5) / height).e;
      const int n = e < 3.0 ? 24 : e < 8.0 ? 6 : 3;
      double sum = 0.0;
      for (int i = 0; i < n * n; ++i) {
        const double v = (y + (i / n + 0.5) / n) / height;
        sum += density(frames.seen((x + (i % n + 0.5) / n) / width, v)) * std::sin(pi * v);
      }
      shares[ring_of(e)] += sum / (n * n);
      total += sum / (n * n);
    }
  }
  for (double& share : shares) {
    share /= total;
  }
  return shares;
}

constexpr std::uint64_t samples_in_all = 1 << 21;

PerRing counted_shares(const std::string& method) {
  const Workers workers(2);
  const std::unique_ptr<ViewSampler> sampler = make_view_sampler(method);
  sampler->aim({.viewport = Viewport(head_orientation(head), radians(view_width_deg),
                                     radians(view_height_deg)),
                .gaze = direction_from(gaze)});
  EquirectFilm film(width, height);
  SamplePass pass;
  const auto black = [](std::span<const SampleJob>, std::span<Rgb> radiance) {
    std::fill(radiance.begin(), radiance.end(), Rgb(0.0F));
  };
  test::run_pass(pass, *sampler, {.count = samples_in_all, .seed = 7}, black, film, workers);
  PerRing shares{};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double e = frames.seen((x + 0.5) / width, (y + 0.5) / height).e;
      shares[ring_of(e)] += film.sample_count(x, y) / static_cast<double>(samples_in_all);
    }
  }
  return shares;
}

class MeanDensity : public testing::TestWithParam<Method> {
 protected:
  std::string text() const {
    std::string text = GetParam().text;
    for (const std::string name : {"MAP", "MASK"}) {
      const std::size_t at = text.find(name);
      if (at != std::string::npos) {
        test::write_weights(folder_ / "painted.exr", weights_width, weights_height, painted);
        text.replace(at, name.size(), (folder_ / "painted.exr").string());
      }
    }
    return text;
  }
  test::TemporaryFolder folder_;
};

// Rings too small for a per cent are counted together with the next. A ring that has next to
// nothing must have next to nothing.
TEST_P(MeanDensity, IsThePublishedOne) {
  PerRing expected{};
  for (const Part& part : GetParam().parts) {
    const PerRing shares = expected_shares(part.density);
    for (std::size_t ring = 0; ring < rings; ++ring) {
      expected[ring] += part.share * shares[ring];
    }
  }
  const PerRing counted = counted_shares(text());
  constexpr double enough = 30'000.0 / samples_in_all;
  double sum_expected = 0.0;
  double sum_counted = 0.0;
  int compared = 0;
  for (std::size_t ring = 0; ring < rings; ++ring) {
    sum_expected += expected[ring];
    sum_counted += counted[ring];
    if (sum_expected >= enough) {
      EXPECT_NEAR(sum_counted / sum_expected, 1.0, 0.01) << "up to " << ring_ends_deg[ring];
      sum_expected = 0.0;
      sum_counted = 0.0;
      ++compared;
    }
  }
  EXPECT_NEAR(sum_counted, sum_expected, 0.01 * enough + 3e-4);
  EXPECT_GE(compared, 5);
}

INSTANTIATE_TEST_SUITE_P(Methods, MeanDensity, testing::ValuesIn(methods()),
                         [](const auto& test) { return std::to_string(test.index); });

}  // namespace
}  // namespace foveola
