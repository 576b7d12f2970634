#include "renderer/film/view_pixels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/view/equirect.h"

namespace foveola {
namespace {

std::size_t whole_lanes(int width, int height) {
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return (count + lane_count - 1) / lane_count * lane_count;
}

Floats load_eight(const float* numbers) {
  Floats lanes;
  __builtin_memcpy(&lanes, numbers, sizeof(lanes));
  return lanes;
}

Floats pick(const std::vector<float>& numbers, const EightPixels& at) {
  return Floats{numbers[at[0]], numbers[at[1]], numbers[at[2]], numbers[at[3]],
                numbers[at[4]], numbers[at[5]], numbers[at[6]], numbers[at[7]]};
}

}  // namespace

float level_for(double sr, int image_height) {
  const double cell_rad = std::numbers::pi / image_height;
  return static_cast<float>(std::max(0.0, std::log2(std::sqrt(sr) / cell_rad)));
}

ViewPixels::ViewPixels(int width, int height)
    : width_(width),
      height_(height),
      u_(whole_lanes(width, height)),
      v_(whole_lanes(width, height)),
      level_(whole_lanes(width, height)) {}

void ViewPixels::place(const Viewport& viewport, int begin, int end) {
  // A copy that no store below can reach, so that compilers make eight pixels at a time.
  const Viewport view = viewport;
  for (int y = begin; y < end; ++y) {
    float* const u = &u_[row(y)];
    float* const v = &v_[row(y)];
    for (int x = 0; x < width_; ++x) {
      const Vec2 image = equirect_from_direction(view.direction(middle_of(x, y)));
      u[x] = image.x;
      v[x] = image.y;
    }
  }
  if (end == height_) {
    std::fill(u_.begin() + count(), u_.end(), u_[count() - 1]);
    std::fill(v_.begin() + count(), v_.end(), v_[count() - 1]);
  }
}

void ViewPixels::choose_levels(const Viewport& viewport, int image_height, int last_level,
                               int begin, int end) {
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < width_; ++x) {
      const double sr = viewport.sr_per_area(middle_of(x, y)) / count();
      level_[row(y) + x] = std::min(level_for(sr, image_height), static_cast<float>(last_level));
    }
  }
}

float ViewPixels::highest_level() const { return *std::max_element(level_.begin(), level_.end()); }

ViewPoints ViewPixels::points(const EightPixels& pixels) const {
  return {.image = {pick(u_, pixels), pick(v_, pixels)}, .level = pick(level_, pixels)};
}

ViewPoints ViewPixels::points_from(std::size_t first) const {
  return {.image = {load_eight(&u_[first]), load_eight(&v_[first])},
          .level = load_eight(&level_[first])};
}

}  // namespace foveola
