// That samples of the BSDF follow their stated density, and the density is one.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/renderer/trace/bsdf_cases.h"
#include "tests/renderer/trace/random_points.h"
#include "tests/renderer/trace/statistics.h"

namespace foveola {
namespace {

using test::unit_square;

constexpr int rings = 40;
constexpr int sectors = 36;
// Of the quadrature, within a bin. Seen at grazing angles a smooth lobe is narrow in azimuth.
constexpr int rings_in_bin = 10;
constexpr int sectors_in_bin = 20;

/// Counts of sampled directions, and of those that the density predicts, in a grid over the sphere;
/// the last bin is for samples that were lost or specular.
struct Histograms {
  std::vector<double> observed = std::vector<double>(rings * sectors + 1);
  std::vector<double> expected = std::vector<double>(rings * sectors + 1);
  double inside = 0.0;  ///< the density's integral
};

std::size_t bin_of(const Vec3& w) {
  const double polar = std::acos(std::clamp(w.z, -1.0F, 1.0F)) / std::numbers::pi;
  const double azimuth = std::atan2(w.y, w.x) / (2.0 * std::numbers::pi) + 0.5;
  const int ring = std::min(rings - 1, static_cast<int>(polar * rings));
  const int sector = std::min(sectors - 1, static_cast<int>(azimuth * sectors));
  return static_cast<std::size_t>(ring * sectors + sector);
}

Histograms histograms_of(const Bsdf& bsdf, int samples, Pcg32& random) {
  Histograms h;
  for (int i = 0; i < samples; ++i) {
    const float u_lobe = unit_float(random.next());
    const auto sample = bsdf.sample(u_lobe, unit_square(random));
    const bool counts = sample && !sample->is_specular;
    (counts ? h.observed[bin_of(sample->incoming)] : h.observed.back()) += 1.0;
  }
  const double polar_step = std::numbers::pi / (rings * rings_in_bin);
  const double azimuth_step = 2.0 * std::numbers::pi / (sectors * sectors_in_bin);
  for (int i = 0; i < rings * rings_in_bin; ++i) {
    const double polar = (i + 0.5) * polar_step;
    for (int k = 0; k < sectors * sectors_in_bin; ++k) {
      const double azimuth = (k + 0.5) * azimuth_step - std::numbers::pi;
      const Vec3 w(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                   std::cos(polar));
      const double probability = bsdf.eval(w).pdf * std::sin(polar) * polar_step * azimuth_step;
      h.expected[static_cast<std::size_t>(i / rings_in_bin * sectors + k / sectors_in_bin)] +=
          samples * probability;
      h.inside += probability;
    }
  }
  h.expected.back() = samples * std::max(0.0, 1.0 - h.inside);
  return h;
}

struct Case {
  NamedMaterial named;
  double cosine;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const double roughness : {0.25, 0.7}) {
    for (const NamedMaterial& named : every_kind(0.7, roughness)) {
      for (const double cosine : {0.9, 0.35}) {
        all.push_back({named, cosine});
      }
    }
  }
  return all;
}

TEST(BsdfSamplingTest, SamplesFollowTheirDensity) {
  constexpr int samples = 40000;
  Pcg32 random(4);
  const std::vector<Case> all = cases();
  const double level = sidak_level(static_cast<int>(all.size()));
  for (const Case& c : all) {
    const ReferenceMaterial& material = c.named.material;
    const Bsdf bsdf(reflectance_of(material), direction_of(c.cosine), scattering_tables());
    const Histograms h = histograms_of(bsdf, samples, random);
    EXPECT_GT(chi_squared_p_value(h.observed, h.expected), level)
        << c.named.name << ' ' << material.roughness << ' ' << c.cosine;
    // What the density leaves are the lost and the specular samples.
    EXPECT_NEAR(h.inside + h.observed.back() / samples, 1.0,
                5.0 * std::sqrt(h.observed.back() + 1.0) / samples + 1e-4)
        << c.named.name << ' ' << material.roughness << ' ' << c.cosine;
  }
}

/// The same of a metal's narrow lobe, by the half vector: in rings of its slope in units of alpha,
/// each of which holds as much of the density of normals as any other.
class SlopeHistograms {
 public:
  SlopeHistograms(const ReferenceMaterial& metal, double cosine)
      : alpha_(metal.alpha()),
        outgoing_(direction_in_plane(cosine)),
        bsdf_(reflectance_of(metal), Vec3(outgoing_), scattering_tables()) {}

  Histograms of(int samples, Pcg32& random) const {
    Histograms h;
    for (int i = 0; i < samples; ++i) {
      const float u_lobe = unit_float(random.next());
      const auto sample = bsdf_.sample(u_lobe, unit_square(random));
      (sample ? h.observed[bin_of(DVec3(sample->incoming))] : h.observed.back()) += 1.0;
    }
    for (int i = 0; i < rings * fine_rings; ++i) {
      for (int k = 0; k < sectors * fine_sectors; ++k) {
        const double probability = cell(i, k);
        h.expected[static_cast<std::size_t>(i / fine_rings * sectors + k / fine_sectors)] +=
            samples * probability;
        h.inside += probability;
      }
    }
    h.expected.back() = samples * std::max(0.0, 1.0 - h.inside);
    return h;
  }

 private:
  // At grazing angles the lobe ends within a few cells.
  static constexpr int fine_rings = 4 * rings_in_bin;
  static constexpr int fine_sectors = 2 * sectors_in_bin;

  std::size_t bin_of(const DVec3& incoming) const {
    const DVec3 half = glm::normalize(outgoing_ + incoming);
    const double squared_slope = (half.x * half.x + half.y * half.y) / std::pow(half.z * alpha_, 2);
    const double within = squared_slope / (1.0 + squared_slope);
    const double azimuth = std::atan2(half.y, half.x) / (2.0 * std::numbers::pi) + 0.5;
    const int ring = std::min(rings - 1, static_cast<int>(within * rings));
    const int sector = std::min(sectors - 1, static_cast<int>(azimuth * sectors));
    return static_cast<std::size_t>(ring * sectors + sector);
  }

  /// The probability of a cell of the quadrature.
  double cell(int i, int k) const {
    const double within = (i + 0.5) / (rings * fine_rings);
    const double azimuth_step = 2.0 * std::numbers::pi / (sectors * fine_sectors);
    const double azimuth = (k + 0.5) * azimuth_step - std::numbers::pi;
    const double slope = alpha_ * std::sqrt(within / (1.0 - within));
    const double z = 1.0 / std::sqrt(1.0 + slope * slope);
    const DVec3 half(z * slope * std::cos(azimuth), z * slope * std::sin(azimuth), z);
    const double oh = glm::dot(outgoing_, half);
    const DVec3 incoming = 2.0 * oh * half - outgoing_;
    if (oh <= 0.0 || incoming.z <= 0.0) {
      return 0.0;
    }
    // d(slope^2 / 2) = alpha^2 / (2 (1 - within)^2) d(within), and z^3 of it is the solid angle.
    const double solid_angle = z * z * z * alpha_ * alpha_ /
                               (2.0 * (1.0 - within) * (1.0 - within)) * azimuth_step /
                               (rings * fine_rings);
    return bsdf_.eval(Vec3(incoming)).pdf * 4.0 * oh * solid_angle;
  }

  double alpha_;
  DVec3 outgoing_;
  Bsdf bsdf_;
};

TEST(BsdfSamplingTest, NarrowLobesFollowTheirDensity) {
  constexpr int samples = 40000;
  Pcg32 random(5);
  const double level = sidak_level(8);
  for (const double roughness : {0.05, 0.15}) {
    for (const double cosine : {0.9, 0.35, 0.1, 0.03}) {
      const ReferenceMaterial metal{.base = 0.7, .metallic = 1.0, .roughness = roughness};
      const Histograms h = SlopeHistograms(metal, cosine).of(samples, random);
      EXPECT_GT(chi_squared_p_value(h.observed, h.expected), level) << roughness << ' ' << cosine;
      EXPECT_NEAR(h.inside + h.observed.back() / samples, 1.0,
                  5.0 * std::sqrt(h.observed.back() + 1.0) / samples + 1e-3)
          << roughness << ' ' << cosine;
    }
  }
}

}  // namespace
}  // namespace foveola
