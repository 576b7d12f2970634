#include "study/prediction/sample_mask.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/angles.h"
#include "renderer/view/equirect.h"

namespace foveola::study {

SampleMask::SampleMask(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void SampleMask::add(const Vec3& middle, double radius_rad, int margin, const Workers& workers) {
  const auto columns = static_cast<std::size_t>(width_);
  const auto min_cosine = static_cast<float>(std::cos(radius_rad));
  const double elevation_rad = azimuth_elevation(middle).elevation_rad;
  const auto row_at = [&](double row_elevation_rad) {
    const double v = 0.5 - row_elevation_rad / std::numbers::pi;
    return std::clamp(static_cast<int>(std::floor(v * height_)), 0, height_ - 1);
  };
  const int top = row_at(elevation_rad + radius_rad);
  const auto rows = static_cast<std::size_t>(row_at(elevation_rad - radius_rad) - top + 1);
  std::vector<std::uint8_t> widened(rows * columns);  // by the margin along each row
  workers.for_each_block(rows, 1, [&](std::size_t row, std::size_t /*end*/) {
    for (std::size_t x = 0; x < columns; ++x) {
      const Vec2 pixel(
          (static_cast<float>(x) + 0.5F) / static_cast<float>(width_),
          (static_cast<float>(row) + static_cast<float>(top) + 0.5F) / static_cast<float>(height_));
      if (glm::dot(direction_from_equirect(pixel), middle) >= min_cosine) {
        for (int beside = -margin; beside <= margin; ++beside) {
          const int there = (static_cast<int>(x) + beside + margin * width_) % width_;
          widened[row * columns + static_cast<std::size_t>(there)] = 1;
        }
      }
    }
  });
  const auto last = top + static_cast<int>(rows) - 1;
  for (int y = std::max(0, top - margin); y <= std::min(height_ - 1, last + margin); ++y) {
    for (int near = std::max(top, y - margin); near <= std::min(last, y + margin); ++near) {
      for (std::size_t x = 0; x < columns; ++x) {
        pixels_[static_cast<std::size_t>(y) * columns + x] |=
            widened[static_cast<std::size_t>(near - top) * columns + x];
      }
    }
  }
}

void SampleMask::keep(std::vector<ViewSample>& samples) const {
  std::erase_if(samples, [this](const ViewSample& sample) { return !holds(sample.image); });
}

std::size_t SampleMask::count() const {
  return static_cast<std::size_t>(std::ranges::count(pixels_, 1));
}

bool SampleMask::holds(const Vec2& image) const {
  const int x = std::clamp(static_cast<int>(image.x * static_cast<float>(width_)), 0, width_ - 1);
  const int y = std::clamp(static_cast<int>(image.y * static_cast<float>(height_)), 0, height_ - 1);
  return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(x)] != 0;
}

}  // namespace foveola::study
