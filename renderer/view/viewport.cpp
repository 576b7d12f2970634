#include "renderer/view/viewport.h"

#include <algorithm>
#include <cctype>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

constexpr std::size_t cells_of_digit = 4;
constexpr std::size_t max_digits = 256;
constexpr std::size_t max_rows = 1024;

bool is_grid(const std::vector<std::string>& rows) {
  const auto is_row = [&](const std::string& row) {
    return row.size() == rows.front().size() && std::ranges::all_of(row, [](char digit) {
             return std::isxdigit(static_cast<unsigned char>(digit)) != 0;
           });
  };
  return !rows.empty() && rows.size() <= max_rows && !rows.front().empty() &&
         rows.front().size() <= max_digits && std::ranges::all_of(rows, is_row);
}

/// 1 for each visible cell, row by row.
std::vector<float> weights_of(const std::vector<std::string>& rows) {
  constexpr const char* remedy = "leave it out if the whole display is visible";
  if (!is_grid(rows)) {
    throw Error("display.seen",
                fmt::format("must be 1 to {} rows of 1 to {} hexadecimal digits, all of one length",
                            max_rows, max_digits),
                remedy);
  }
  std::vector<float> weights;
  for (const std::string& row : rows) {
    for (const char digit : row) {
      const auto bits = static_cast<unsigned>(std::stoi(std::string(1, digit), nullptr, 16));
      for (std::size_t cell = cells_of_digit; cell-- > 0;) {
        weights.push_back((bits >> cell & 1U) != 0 ? 1.0F : 0.0F);
      }
    }
  }
  if (std::ranges::count(weights, 1.0F) == 0) {
    throw Error("display.seen", "has no visible cell", remedy);
  }
  return weights;
}

std::size_t cell_at(float position, float cells) {
  const float cell = std::clamp(position * cells, 0.0F, cells - 1.0F);
  return static_cast<std::size_t>(cell);
}

float half_extent(double fov_rad) {
  if (!(fov_rad > 0.0 && fov_rad < std::numbers::pi)) {
    throw Error("field of view", fmt::format("{} degrees cannot be shown flat", degrees(fov_rad)),
                "choose one between 0 and 180 degrees");
  }
  return static_cast<float>(std::tan(0.5 * fov_rad));
}

/// The squared distance from the lens' axis to the display's furthest corner.
double furthest_d2(const RadialLens& lens, const Vec2& half_size) {
  const Vec2 to_corner = 2.0F * glm::max(lens.axis, 1.0F - lens.axis) * half_size;
  return glm::dot(to_corner, to_corner);
}

const RadialLens& checked(const RadialLens& lens, const Vec2& half_size) {
  constexpr int steps = 64;
  const double furthest = furthest_d2(lens, half_size);
  bool rises = std::isfinite(lens.axis.x) && std::isfinite(lens.axis.y);
  for (int i = 0; i <= steps; ++i) {
    rises = rises && growth(lens, furthest * i / steps) > 0.0;
  }
  if (!rises) {
    throw Error("lens",
                fmt::format("k1 = {}, k2 = {} fold the display's corners back", lens.k1, lens.k2),
                "choose coefficients under which the distance from the axis grows to the corners");
  }
  return lens;
}

/// The distance on the display that appears at `distance`; `furthest` bounds it.
double on_display(const RadialLens& lens, double distance, double furthest) {
  double low = 0.0;
  double high = furthest;
  double d = std::min(distance, high);
  constexpr int max_steps = 60;
  for (int step = 0; step < max_steps; ++step) {
    const double excess = d * magnification(lens, d * d) - distance;
    (excess > 0.0 ? high : low) = d;
    const double newton = d - excess / growth(lens, d * d);
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (next == d) {
      break;
    }
    d = next;
  }
  return d;
}

}  // namespace

SeenPart::SeenPart(std::vector<std::string> rows)
    : rows_(std::move(rows)),
      cells_(rows_.empty() ? 0.0F : static_cast<float>(cells_of_digit * rows_.front().size()),
             static_cast<float>(rows_.size())),
      seen_(static_cast<std::size_t>(cells_.x), static_cast<std::size_t>(cells_.y),
            weights_of(rows_)),
      share_(seen_.total() / (static_cast<double>(cells_.x) * static_cast<double>(cells_.y))) {}

bool SeenPart::contains(const Vec2& plane) const {
  return seen_.probability(cell_at(plane.x, cells_.x), cell_at(plane.y, cells_.y)) > 0.0F;
}

Vec2 SeenPart::place(const Vec2& point) const {
  // Rounding must not move a place into the next cell, which may be invisible.
  constexpr float farthest_within = 1.0F - 0x1p-13F;
  const PiecewiseConstant2D::Point place = seen_.sample(point);
  const Vec2 cell(static_cast<float>(place.column), static_cast<float>(place.row));
  return (cell + glm::min(place.within, Vec2(farthest_within))) / cells_;
}

double fov_across_deg(double ratio, double fov_deg) {
  return degrees(2.0 * std::atan(ratio * std::tan(0.5 * radians(fov_deg))));
}

Vec3 gaze_in_head(const AzimuthElevation& heading, const Vec3& gaze) {
  return glm::normalize(glm::conjugate(head_orientation(heading)) * gaze);
}

Viewport::Viewport(const Quat& head, double horizontal_fov_rad, double vertical_fov_rad,
                   const RadialLens& lens)
    : head_(head),
      half_size_(half_extent(horizontal_fov_rad), half_extent(vertical_fov_rad)),
      lens_(checked(lens, half_size_)),
      right_(head * Vec3(1.0F, 0.0F, 0.0F)),
      up_(head * Vec3(0.0F, 1.0F, 0.0F)),
      forward_(head * Vec3(0.0F, 0.0F, -1.0F)) {}

std::optional<Vec2> Viewport::project(const Vec3& direction) const {
  const Vec3 local = glm::conjugate(head_) * direction;
  if (local.z >= 0.0F) {
    return std::nullopt;
  }
  Vec2 offset = Vec2(local.x, -local.y) / -local.z;
  if (lens_.k1 != 0.0F || lens_.k2 != 0.0F) {
    const double distance = glm::length(offset);
    const double furthest = std::sqrt(furthest_d2(lens_, half_size_));
    if (distance > furthest * magnification(lens_, furthest * furthest)) {
      return std::nullopt;
    }
    const double display = on_display(lens_, distance, furthest);
    offset *= distance > 0.0 ? static_cast<float>(display / distance) : 1.0F;
  }
  const Vec2 plane = lens_.axis + 0.5F * offset / half_size_;
  const bool inside = plane.x >= 0.0F && plane.x <= 1.0F && plane.y >= 0.0F && plane.y <= 1.0F;
  return inside ? std::optional(plane) : std::nullopt;
}

double Viewport::sr_per_area(const Vec2& plane) const {
  return foveola::sr_per_area(half_size_, lens_, plane);
}

}  // namespace foveola
