#include "renderer/view/seen_part.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "renderer/base/error.h"

namespace foveola {
namespace {

constexpr std::size_t cells_of_digit = 4;
constexpr std::size_t most_digits = 256;
constexpr std::size_t most_rows = 1024;

bool is_grid(const std::vector<std::string>& rows) {
  const auto is_row = [&](const std::string& row) {
    return row.size() == rows.front().size() && std::all_of(row.begin(), row.end(), [](char digit) {
             return std::isxdigit(static_cast<unsigned char>(digit)) != 0;
           });
  };
  return !rows.empty() && rows.size() <= most_rows && !rows.front().empty() &&
         rows.front().size() <= most_digits && std::all_of(rows.begin(), rows.end(), is_row);
}

/// 1 for each cell that is seen, row by row.
std::vector<float> weights_of(const std::vector<std::string>& rows) {
  if (!is_grid(rows)) {
    throw Error("display", "what is seen of it is no grid of cells",
                "write rows of hexadecimal digits, each as long as the others");
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
  if (std::count(weights.begin(), weights.end(), 1.0F) == 0) {
    throw Error("display", "nothing of it is seen", "leave out what is seen of it");
  }
  return weights;
}

std::size_t cell_at(float position, float cells) {
  const float cell = std::clamp(position * cells, 0.0F, cells - 1.0F);
  return static_cast<std::size_t>(cell);
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
  // Rounding shall not carry a place into the next cell, which may not be seen.
  constexpr float farthest_within = 1.0F - 0x1p-13F;
  const PiecewiseConstant2D::Point place = seen_.sample(point);
  const Vec2 cell(static_cast<float>(place.column), static_cast<float>(place.row));
  return (cell + glm::min(place.within, Vec2(farthest_within))) / cells_;
}

}  // namespace foveola
