#include "renderer/headset/seen_by_eyes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "renderer/headset/eye_views.h"

namespace foveola {
namespace {

constexpr int cells = 64;          // beside each other, and one below the other
constexpr int cells_of_digit = 4;  // SeenPart's
constexpr int points_of_cell = 4;  // beside each other; as many more stand around the cell

/// Positive to the left of the line from `a` to `b`.
float side_of(const Vec2& a, const Vec2& b, const Vec2& point) {
  return (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x);
}

bool is_hidden(const Vec2& point, const HiddenTriangles& hidden) {
  for (std::size_t i = 0; i + 2 < hidden.size(); i += 3) {
    const float first = side_of(hidden[i], hidden[i + 1], point);
    const float second = side_of(hidden[i + 1], hidden[i + 2], point);
    const float third = side_of(hidden[i + 2], hidden[i], point);
    const bool is_inside = (first >= 0.0F && second >= 0.0F && third >= 0.0F) ||
                           (first <= 0.0F && second <= 0.0F && third <= 0.0F);
    if (is_inside) {
      return true;
    }
  }
  return false;
}

/// An eye in the head, which sees along its own -z.
struct EyeInHead {
  Quat eye_from_head;
  Vec2 low;  ///< of what it sees on the plane at distance 1
  Vec2 high;

  EyeInHead(const XrView& eye, const Quat& head)
      : eye_from_head(glm::conjugate(orientation_of(eye.pose)) * head),
        low(std::tan(eye.fov.angleLeft), std::tan(eye.fov.angleDown)),
        high(std::tan(eye.fov.angleRight), std::tan(eye.fov.angleUp)) {}

  bool sees(const Vec3& direction_in_head, const HiddenTriangles& hidden) const {
    const Vec3 direction = eye_from_head * direction_in_head;
    if (direction.z >= 0.0F) {
      return false;
    }
    const Vec2 point = Vec2(direction) / -direction.z;
    return glm::all(glm::greaterThanEqual(point, low)) &&
           glm::all(glm::lessThanEqual(point, high)) && !is_hidden(point, hidden);
  }
};

}  // namespace

std::shared_ptr<const SeenPart> seen_by_eyes(const std::array<XrView, 2>& eyes, const Quat& head,
                                             const FieldOfView& both,
                                             const std::array<HiddenTriangles, 2>& hidden) {
  const std::array in_head{EyeInHead(eyes[0], head), EyeInHead(eyes[1], head)};
  const Viewport view = viewport_of(Quat(1.0F, 0.0F, 0.0F, 0.0F), both);
  const auto is_point_seen = [&](int column, int row) {
    const Vec2 plane = Vec2(static_cast<float>(column), static_cast<float>(row)) /
                       static_cast<float>(cells * points_of_cell);
    const Vec3 direction = view.direction(plane);
    return in_head[0].sees(direction, hidden[0]) || in_head[1].sees(direction, hidden[1]);
  };
  const auto is_cell_seen = [&](int column, int row) {
    for (int y = -1; y <= points_of_cell + 1; ++y) {
      for (int x = -1; x <= points_of_cell + 1; ++x) {
        if (is_point_seen(column * points_of_cell + x, row * points_of_cell + y)) {
          return true;
        }
      }
    }
    return false;
  };
  std::vector<std::string> rows;
  int seen = 0;
  for (int row = 0; row < cells; ++row) {
    std::string digits;
    for (int column = 0; column < cells; column += cells_of_digit) {
      int bits = 0;
      for (int cell = 0; cell < cells_of_digit; ++cell) {
        const int bit = is_cell_seen(column + cell, row) ? 1 : 0;
        bits = 2 * bits + bit;
        seen += bit;
      }
      digits += "0123456789abcdef"[bits];
    }
    rows.push_back(digits);
  }
  return seen == 0 || seen == cells * cells ? nullptr : std::make_shared<const SeenPart>(rows);
}

}  // namespace foveola
