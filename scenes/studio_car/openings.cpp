#include "scenes/studio_car/openings.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace foveola::scenes::car {
namespace {

/// Shares of a sheet's columns and rows, from `from` to below `to`.
struct Range {
  double from = 0.0;
  double to = 1.0;
  bool contains(double share) const { return share > from && share < to; }
};

Cells in(const Sheet& sheet, const Range& columns, const Range& rows) {
  return [columns, rows, across = static_cast<double>(sheet.columns - 1),
          up = static_cast<double>(sheet.rows - 1)](std::size_t column, std::size_t row) {
    return columns.contains((static_cast<double>(column) + 0.5) / across) &&
           rows.contains((static_cast<double>(row) + 0.5) / up);
  };
}

/// The same on both sides of the middle, `out` counted from there.
Cells on_either_side(const Sheet& sheet, const Range& out, const Range& rows) {
  return [out, rows, across = static_cast<double>(sheet.columns - 1),
          up = static_cast<double>(sheet.rows - 1)](std::size_t column, std::size_t row) {
    const double u = 2.0 * (static_cast<double>(column) + 0.5) / across - 1.0;
    return out.contains(std::abs(u)) && rows.contains((static_cast<double>(row) + 0.5) / up);
  };
}

}  // namespace

Cells is_grille(const Sheet& nose) { return on_either_side(nose, {-1.0, 0.34}, {0.6, 0.9}); }

Cells is_air_intake(const Sheet& nose) {
  return
      [middle = on_either_side(nose, {-1.0, 0.52}, {0.15, 0.45}),
       side = on_either_side(nose, {0.64, 0.9}, {0.15, 0.45})](
          std::size_t column, std::size_t row) { return middle(column, row) || side(column, row); };
}

Cells is_headlight(const Sheet& nose) { return on_either_side(nose, {0.46, 0.92}, {0.6, 0.9}); }

Cells is_tail_light(const Sheet& tail) { return on_either_side(tail, {0.34, 0.94}, {0.7, 0.9}); }

Cells is_plate_recess(const Sheet& tail) { return on_either_side(tail, {-1.0, 0.27}, {0.45, 0.7}); }

Cells is_diffuser(const Sheet& tail) { return on_either_side(tail, {-1.0, 0.62}, {0.0, 0.2}); }

Cells is_door_window(const Sheet& side) { return in(side, {0.12, 0.583}, {0.05, 0.9}); }

Cells is_quarter_window(const Sheet& side) { return in(side, {0.613, 0.83}, {0.05, 0.9}); }

Cells is_middle_pillar(const Sheet& side) { return in(side, {0.583, 0.613}, {0.05, 0.9}); }

Cells is_windscreen(const Sheet& top) { return in(top, {0.02, 0.3}, {0.05, 0.95}); }

Cells is_rear_window(const Sheet& top) { return in(top, {0.7, 0.96}, {0.1, 0.9}); }

Cells none_of(std::vector<Cells> openings) {
  return [openings = std::move(openings)](std::size_t column, std::size_t row) {
    return std::none_of(openings.begin(), openings.end(),
                        [&](const Cells& opening) { return opening(column, row); });
  };
}

}  // namespace foveola::scenes::car
