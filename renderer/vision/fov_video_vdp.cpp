#include "renderer/vision/fov_video_vdp.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/angles.h"
#include "renderer/base/error.h"
#include "renderer/image/tone_mapping.h"

namespace foveola {
namespace {

constexpr float darkest_cd_m2 = 0.1F;  ///< minimum luminance in contrasts
constexpr float max_contrast = 1000.0F;
constexpr int smallest_side = 4;         ///< minimum side of the last band, in pixels
constexpr double lowest_band_cpd = 0.5;  ///< the first band at or below it is the last
constexpr double transient_weight = 0.25;
constexpr double over_pixels = 1.52134;  ///< exponents of pooling
constexpr double over_channels = 0.666092;

/// One level of a pyramid.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<float> values;

  Plane(int columns, int rows)
      : Plane(columns, rows, std::vector<float>(static_cast<std::size_t>(columns) * rows)) {}
  Plane(int columns, int rows, std::vector<float> known)
      : width(columns), height(rows), values(std::move(known)) {}

  float* row(int y) { return values.data() + static_cast<std::size_t>(y) * width; }
  const float* row(int y) const { return values.data() + static_cast<std::size_t>(y) * width; }
};

void check(bool is_right, const std::string& what, const std::string& fault) {
  if (!is_right) {
    throw Error(what, fault);
  }
}

// --- The pyramid (Burt and Adelson 1983, a = 0.4) ---

constexpr std::array kernel = {0.05F, 0.25F, 0.4F, 0.25F, 0.05F};

/// Beyond its borders a row is mirrored, with its outermost sample repeated.
int mirrored(int i, int size) {
  while (i < 0 || i >= size) {
    i = i < 0 ? -1 - i : 2 * size - 1 - i;
  }
  return i;
}

/// Calls row(y) for every row, in parallel.
template <typename Row>
void for_each_row(int rows, const Workers& workers, const Row& row) {
  workers.for_each_block(static_cast<std::size_t>(rows), 16,
                         [&](std::size_t begin, std::size_t end) {
                           for (std::size_t y = begin; y < end; ++y) {
                             row(static_cast<int>(y));
                           }
                         });
}

/// Blurred and subsampled by two in both directions.
Plane reduced(const Plane& plane, const Workers& workers) {
  Plane across((plane.width + 1) / 2, plane.height);
  for_each_row(plane.height, workers, [&](int y) {
    const float* from = plane.row(y);
    float* to = across.row(y);
    for (int x = 0; x < across.width; ++x) {
      float sum = 0.0F;
      for (int k = -2; k <= 2; ++k) {
        sum += kernel[static_cast<std::size_t>(k + 2)] * from[mirrored(2 * x + k, plane.width)];
      }
      to[x] = sum;
    }
  });
  Plane result(across.width, (plane.height + 1) / 2);
  for_each_row(result.height, workers, [&](int y) {
    float* to = result.row(y);
    for (int k = -2; k <= 2; ++k) {
      const float* from = across.row(mirrored(2 * y + k, plane.height));
      const float weight = kernel[static_cast<std::size_t>(k + 2)];
      for (int x = 0; x < result.width; ++x) {
        to[x] += weight * from[x];
      }
    }
  });
  return result;
}

/// The samples of a coarser row behind a finer one, with their weights. Beyond its borders the
/// outermost sample is repeated.
struct Taps {
  std::array<int, 3> at;
  std::array<float, 3> weights;

  Taps(int fine, int coarse_size) {
    const int middle = fine / 2;
    at = {std::max(middle - 1, 0), middle, std::min(middle + 1, coarse_size - 1)};
    weights = fine % 2 == 0 ? std::array{0.1F, 0.8F, 0.1F} : std::array{0.0F, 0.5F, 0.5F};
  }
};

Plane expanded(const Plane& plane, int width, int height, const Workers& workers) {
  Plane down(plane.width, height);
  for_each_row(height, workers, [&](int y) {
    const Taps taps(y, plane.height);
    float* to = down.row(y);
    for (std::size_t k = 0; k < 3; ++k) {
      const float* from = plane.row(taps.at[k]);
      for (int x = 0; x < plane.width; ++x) {
        to[x] += taps.weights[k] * from[x];
      }
    }
  });
  Plane result(width, height);
  for_each_row(height, workers, [&](int y) {
    const float* from = down.row(y);
    float* to = result.row(y);
    for (int x = 0; x < width; ++x) {
      const Taps taps(x, plane.width);
      to[x] = taps.weights[0] * from[taps.at[0]] + taps.weights[1] * from[taps.at[1]] +
              taps.weights[2] * from[taps.at[2]];
    }
  });
  return result;
}

// --- Perceived differences ---

/// The visible difference of two contrasts, with mutual masking, to the power of pooling.
double pooled_difference(float sensitivity, float seen, float expected, float masking) {
  constexpr float mask_scale = 0.106209F;  // 10^-0.973838
  const float mask = sensitivity * std::min(std::abs(seen), std::abs(expected)) * mask_scale;
  const float difference = std::pow(sensitivity * std::abs(seen - expected), 2.4F);
  const float visible = std::min(difference / (1.0F + std::pow(mask, masking)), 1e4F);
  return std::pow(visible, static_cast<float>(over_pixels));
}

// --- Time ---

/// Weights of the frames of the last 250 ms, the newest first (section 4.2).
std::vector<std::vector<float>> temporal_filters(double rate_hz) {
  check(rate_hz > 0.0 && rate_hz <= 1000.0, "sequence",
        fmt::format("cannot have {} frames a second", rate_hz));
  const auto taps = static_cast<std::size_t>(std::ceil(0.25 * rate_hz));
  std::vector<double> times_s(taps, 0.0);
  std::vector<double> sustained(taps);
  for (std::size_t i = 0; i < taps; ++i) {
    if (taps > 1) {
      times_s[i] = static_cast<double>(taps) / rate_hz * static_cast<double>(i) /
                   static_cast<double>(taps - 1);
    }
    const double decades = std::log(times_s[i] + 1e-4) - std::log(0.06);
    sustained[i] = std::exp(-decades * decades / 0.5);
  }
  const double sum = std::accumulate(sustained.begin(), sustained.end(), 0.0);
  std::vector<std::vector<float>> filters(2, std::vector<float>(taps, 0.0F));
  for (std::size_t i = 0; i < taps; ++i) {
    filters[0][i] = static_cast<float>(sustained[i] / sum);
    if (i + 1 < taps) {
      filters[1][i] = static_cast<float>(0.062170507756932 * (sustained[i + 1] - sustained[i]) /
                                         sum / (times_s[i + 1] - times_s[i]));
    }
  }
  return filters;
}

/// The angle of a place in [0, 1] along a side from the display's centre.
float angle_deg(float place, float half_side) {
  return static_cast<float>(degrees(std::atan((2.0F * place - 1.0F) * half_side)));
}

std::vector<float> angles_deg(int pixels, float half_side) {
  std::vector<float> angles;
  for (int i = 0; i < pixels; ++i) {
    const float place = (static_cast<float>(i) + 0.5F) / static_cast<float>(pixels);
    angles.push_back(angle_deg(place, half_side));
  }
  return angles;
}

/// Relative number of pixels per degree at this angle from the centre of a flat display, half a
/// pixel of which is as wide as `pixel_tangent`.
float magnification(const Vec2& from_middle_deg, float pixel_tangent) {
  constexpr auto radian_deg = static_cast<float>(radians(1.0));
  const float tangent = std::tan(radian_deg * std::min(glm::length(from_middle_deg), 89.9F));
  return (1.0F + tangent * tangent) / std::max(1.0F - tangent * pixel_tangent, 0.1F);
}

}  // namespace

struct FovVideoVdp::Band {
  int width;
  int height;
  float frequency_cpd;             ///< in the display's centre
  float gain;                      ///< of its contrasts
  std::vector<float> columns_deg;  ///< angle of each column from the display's centre
  std::vector<float> rows_deg;
};

FovVideoVdp::FovVideoVdp(const VdpDisplay& display, const IVec2& size,
                         const std::optional<Vec2>& fixation_px,
                         const std::optional<double>& rate_hz, const Workers& workers)
    : display_(display),
      size_(size),
      workers_(workers),
      half_pixel_(static_cast<float>(std::tan(radians(0.5 / display.pixels_per_degree)))),
      filters_(rate_hz ? temporal_filters(*rate_hz) : std::vector<std::vector<float>>{{1.0F}}) {
  check(display.pixels_per_degree > 0.0 && display.pixels_per_degree < 1e4 &&
            display.half_size.x > 0.0F && display.half_size.y > 0.0F,
        "display", "has no size");
  check(display.black_cd_m2 >= 0.0 && display.white_cd_m2 > display.black_cd_m2 &&
            display.white_cd_m2 <= 1e6,
        "display", "its white is not brighter than its black, or above 1e6 cd/m2");
  check(!fixation_px || (fixation_px->x >= 0.0F && fixation_px->x <= static_cast<float>(size.x) &&
                         fixation_px->y >= 0.0F && fixation_px->y <= static_cast<float>(size.y)),
        "fixation", fmt::format("is outside of the picture of {} x {} pixels", size.x, size.y));
  sensitivity_.emplace_back(VdpChannel::sustained);
  if (rate_hz) {
    sensitivity_.emplace_back(VdpChannel::transient);
  }
  if (fixation_px) {
    const Vec2 place = (*fixation_px + 0.5F) / Vec2(size);
    fixation_deg_ =
        Vec2(angle_deg(place.x, display.half_size.x), angle_deg(place.y, display.half_size.y));
  }
  const double finest_cpd = 0.5 * display.pixels_per_degree;
  int width = size.x;
  int height = size.y;
  for (int level = 0;; ++level) {
    const double frequency_cpd =
        level == 0 ? finest_cpd : 0.3228 * finest_cpd * std::exp2(1 - level);
    bands_.push_back({.width = width,
                      .height = height,
                      .frequency_cpd = static_cast<float>(frequency_cpd),
                      .gain = level == 0 ? 1.0F : 2.0F,
                      .columns_deg = angles_deg(width, display.half_size.x),
                      .rows_deg = angles_deg(height, display.half_size.y)});
    if (frequency_cpd <= lowest_band_cpd || std::min(width, height) < smallest_side) {
      break;
    }
    width = (width + 1) / 2;
    height = (height + 1) / 2;
  }
}

/// A band's input: a picture minus its blurred self.
struct FovVideoVdp::Level {
  std::vector<float> fine;
  std::vector<float> base;
};

FovVideoVdp::~FovVideoVdp() = default;

FovVideoVdp::Luminance FovVideoVdp::luminance_of(const RgbImage& image) const {
  check(image.width == size_.x && image.height == size_.y, "picture",
        fmt::format("is of {} x {} pixels, not {} x {}", image.width, image.height, size_.x,
                    size_.y));
  Luminance luminance(image.pixels.size());
  const double range = display_.white_cd_m2 - display_.black_cd_m2;
  for (std::size_t i = 0; i < luminance.size(); ++i) {
    const Rgb& encoded = image.pixels[i];
    check(std::isfinite(encoded.r + encoded.g + encoded.b), "picture", "is not finite everywhere");
    const DVec3 linear(linear_from_srgb(encoded.r), linear_from_srgb(encoded.g),
                       linear_from_srgb(encoded.b));
    luminance[i] = static_cast<float>(range * glm::dot(linear, DVec3(0.2126, 0.7152, 0.0722)) +
                                      display_.black_cd_m2);
  }
  return luminance;
}

FovVideoVdp::Pyramid FovVideoVdp::pyramid_of(Luminance luminance) const {
  Pyramid pyramid;
  Plane fine(size_.x, size_.y, std::move(luminance));
  for (const Band& band : bands_) {
    Plane coarse = reduced(fine, workers_);
    Plane base = expanded(coarse, band.width, band.height, workers_);
    pyramid.push_back({.fine = std::move(fine.values), .base = std::move(base.values)});
    fine = std::move(coarse);
  }
  return pyramid;
}

FovVideoVdp::Pyramid FovVideoVdp::seen_by(VdpChannel channel,
                                          const std::deque<Luminance>& frames) const {
  const std::vector<float>& weights = filters_[static_cast<std::size_t>(channel)];
  Luminance sum(frames.front().size(), 0.0F);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const Luminance& frame = frames[std::min(k, frames.size() - 1)];
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] += weights[k] * frame[i];
    }
  }
  return pyramid_of(std::move(sum));
}

float FovVideoVdp::sensitivity(const VdpSensitivityTable& table, const Band& band, int x, int y,
                               float background_cd_m2) const {
  if (!fixation_deg_) {
    return table.at(band.frequency_cpd, background_cd_m2, 0.0F);
  }
  const Vec2 from_middle_deg(band.columns_deg[static_cast<std::size_t>(x)],
                             band.rows_deg[static_cast<std::size_t>(y)]);
  return table.at(band.frequency_cpd * magnification(from_middle_deg, half_pixel_),
                  background_cd_m2, glm::length(from_middle_deg - *fixation_deg_));
}

double FovVideoVdp::channel_difference(VdpChannel channel, const Pyramid& image,
                                       const Pyramid& reference, const Pyramid& background) const {
  const VdpSensitivityTable& table = sensitivity_[static_cast<std::size_t>(channel)];
  const float masking = channel == VdpChannel::sustained ? 2.43685F : 4.946F;
  double difference = 0.0;
  for (std::size_t level = 0; level < bands_.size(); ++level) {
    const Band& band = bands_[level];
    std::vector<double> row_sums(static_cast<std::size_t>(band.height), 0.0);
    for_each_row(band.height, workers_, [&](int y) {
      for (int x = 0; x < band.width; ++x) {
        const std::size_t i = static_cast<std::size_t>(y) * band.width + x;
        const float adapted = std::max(background[level].base[i], darkest_cd_m2);
        const auto contrast = [&](const Level& of) {
          return std::min((of.fine[i] - of.base[i]) / adapted, max_contrast);
        };
        const float seen = contrast(image[level]);
        const float expected = contrast(reference[level]);
        if (seen != expected) {
          row_sums[static_cast<std::size_t>(y)] += pooled_difference(
              band.gain * sensitivity(table, band, x, y, adapted), seen, expected, masking);
        }
      }
    });
    const double sum = std::accumulate(row_sums.begin(), row_sums.end(), 0.0);
    const double pixels = static_cast<double>(band.width) * band.height;
    difference += std::pow(sum / pixels, 1.0 / over_pixels);
  }
  return difference;
}

void FovVideoVdp::add(const RgbImage& image, const RgbImage& reference) {
  images_.push_front(luminance_of(image));
  references_.push_front(luminance_of(reference));
  images_.resize(std::min(images_.size(), filters_[0].size()));
  references_.resize(images_.size());
  const Pyramid background = seen_by(VdpChannel::sustained, references_);
  double difference = channel_difference(
      VdpChannel::sustained, seen_by(VdpChannel::sustained, images_), background, background);
  if (filters_.size() > 1) {
    const double transient =
        channel_difference(VdpChannel::transient, seen_by(VdpChannel::transient, images_),
                           seen_by(VdpChannel::transient, references_), background);
    difference = std::pow(
        std::pow(difference, over_channels) + std::pow(transient_weight * transient, over_channels),
        1.0 / over_channels);
  }
  sum_ += difference;
  ++frames_;
}

double FovVideoVdp::jod() const {
  return 10.0 - 0.0161713 * std::pow(sum_ / frames_, std::pow(10.0, -0.2280));
}

}  // namespace foveola
