#include "study/prediction/sample_mask.h"

#include <algorithm>

#include "renderer/view/equirect.h"

namespace foveola::study {

SampleMask::SampleMask(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

void SampleMask::add(const std::function<bool(const Vec3& direction)>& is_wanted, int margin,
                     const Workers& workers) {
  const auto columns = static_cast<std::size_t>(width_);
  const auto rows = static_cast<std::size_t>(height_);
  std::vector<std::uint8_t> widened(pixels_.size());  // by the margin along each row
  workers.for_each_block(rows, 1, [&](std::size_t y, std::size_t /*end*/) {
    for (std::size_t x = 0; x < columns; ++x) {
      const Vec2 middle((static_cast<float>(x) + 0.5F) / static_cast<float>(width_),
                        (static_cast<float>(y) + 0.5F) / static_cast<float>(height_));
      if (is_wanted(direction_from_equirect(middle))) {
        for (int beside = -margin; beside <= margin; ++beside) {
          const auto there = (static_cast<int>(x) + beside + margin * width_) % width_;
          widened[y * columns + static_cast<std::size_t>(there)] = 1;
        }
      }
    }
  });
  workers.for_each_block(rows, 1, [&](std::size_t y, std::size_t /*end*/) {
    const int first = std::max(0, static_cast<int>(y) - margin);
    const int last = std::min(height_ - 1, static_cast<int>(y) + margin);
    for (int row = first; row <= last; ++row) {
      for (std::size_t x = 0; x < columns; ++x) {
        pixels_[y * columns + x] |= widened[static_cast<std::size_t>(row) * columns + x];
      }
    }
  });
}

void SampleMask::keep(std::vector<ViewSample>& samples) const {
  std::erase_if(samples, [this](const ViewSample& sample) { return !holds(sample.image); });
}

std::size_t SampleMask::count() const {
  return static_cast<std::size_t>(std::count(pixels_.begin(), pixels_.end(), 1));
}

bool SampleMask::holds(const Vec2& image) const {
  const int x = std::clamp(static_cast<int>(image.x * static_cast<float>(width_)), 0, width_ - 1);
  const int y = std::clamp(static_cast<int>(image.y * static_cast<float>(height_)), 0, height_ - 1);
  return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(x)] != 0;
}

}  // namespace foveola::study
