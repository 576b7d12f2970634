#include "renderer/film/view_pixels.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "renderer/film/rounded_log2.h"
#include "renderer/view/display_plane.h"
#include "renderer/view/equirect.h"

namespace foveola {
namespace {

/// How many cells of level 0 a patch of `sr` steradians is wide.
double cells_across(double sr, int image_height) {
  const double cell_rad = std::numbers::pi / image_height;
  return std::sqrt(sr) / cell_rad;
}

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
  return static_cast<float>(std::max(0.0, std::log2(cells_across(sr, image_height))));
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
  const Vec2 half_size = viewport.half_size();
  const RadialLens lens = viewport.lens();
  const double pixels = count();
  std::vector<double> widths(static_cast<std::size_t>(width_));
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < width_; ++x) {
      widths[x] =
          cells_across(sr_per_area(half_size, lens, middle_of(x, y)) / pixels, image_height);
    }
    const std::span<float> levels(&level_[row(y)], widths.size());
    rounded_log2(widths, levels);
    for (float& level : levels) {
      level = std::clamp(level, 0.0F, static_cast<float>(last_level));
    }
  }
}

float ViewPixels::highest_level() const {
  Floats highest{};
  for (std::size_t first = 0; first < level_.size(); first += lane_count) {
    highest = larger(highest, load_eight(&level_[first]));
  }
  FloatLanes lanes;
  lanes.store(highest);
  return *std::max_element(lanes.begin(), lanes.end());
}

ViewPoints ViewPixels::points(const EightPixels& pixels) const {
  return {.image = {pick(u_, pixels), pick(v_, pixels)}, .level = pick(level_, pixels)};
}

ViewPoints ViewPixels::points_from(std::size_t first) const {
  return {.image = {load_eight(&u_[first]), load_eight(&v_[first])},
          .level = load_eight(&level_[first])};
}

}  // namespace foveola
