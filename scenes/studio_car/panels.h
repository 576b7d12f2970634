// Sheets of metal and glass on the car's skin.
#pragma once

#include <functional>
#include <vector>

#include "scenes/modelling/shapes.h"

namespace foveola::scenes::car {

using Curve = std::function<DVec3(double)>;

/// `cells` + 1 numbers from `from` to `to`, evenly spaced.
std::vector<double> even(double from, double to, int cells);

/// The numbers of both in falling order, those closer than `apart` to a former one left out.
std::vector<double> falling(std::vector<double> numbers, double apart);

/// A net of points on the skin in rows of `columns` points.
struct Sheet {
  std::size_t columns = 0;
  std::size_t rows = 0;
  std::vector<DVec3> points;

  const DVec3& at(std::size_t column, std::size_t row) const {
    return points[row * columns + column];
  }
  std::vector<DVec3> row(std::size_t row) const;
  std::vector<DVec3> column(std::size_t column) const;
};

/// The net position(u, v), pulled to the skin.
Sheet sheet(const std::vector<double>& us, const std::vector<double>& vs,
            const std::function<DVec3(double u, double v)>& position);

/// The net between four lines on the skin that meet at its corners (Coons 1967): `bottom` and `top`
/// run along its rows, `left` and `right` along its columns.
Sheet sheet_between(const std::vector<DVec3>& bottom, const std::vector<DVec3>& top,
                    const std::vector<DVec3>& left, const std::vector<DVec3>& right);

/// Whether a sheet's cell, counted from its first column and row, belongs to something.
using Cells = std::function<bool(std::size_t column, std::size_t row)>;

/// The sheet's cells, facing outwards, `depth` below the skin.
Shape plate(const Sheet& sheet, const Cells& cells, double depth = 0.0);
Shape plate(const Sheet& sheet, double depth = 0.0);

/// The shape with its open edges bevelled and folded inwards by `fold`.
Shape with_folded_edges(Shape shape, double fold);

/// A pit that the sheet's cells open into: a floor `depth` below the skin and walls up to it.
Shape pit(const Sheet& sheet, const Cells& cells, double depth);

/// Round beads along the shape's open edges, as rubber seals and trim.
Shape beads_along_edges(const Shape& shape, double radius);

/// The shape and its mirror image across the car's middle.
Shape on_both_sides(const Shape& shape);

}  // namespace foveola::scenes::car
