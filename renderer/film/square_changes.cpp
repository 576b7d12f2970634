#include "renderer/film/square_changes.h"

#include <atomic>

#include "renderer/film/cells_around.h"

namespace foveola {

SquareChanges::SquareChanges(int width, int height) : size_(width, height) {
  std::uint32_t first = 0;
  for (int level = 1; level < FilmTile::levels; ++level) {
    Level& at = levels_[static_cast<std::size_t>(level)];
    at = {first, (width + (1 << level) - 1) >> level, (height + (1 << level) - 1) >> level};
    first = at.number(at.width - 1, at.height - 1) + 1;
  }
  changed_at_ = make_lazy_array<FilmRevision>(first);
}

void SquareChanges::note(int level, int x, int y, FilmRevision revision) {
  const Level& at = levels_[static_cast<std::size_t>(level)];
  note_in_row(at, x, y - 1, revision);
  note_in_row(at, x, y, revision);
  // Over a pole the same row comes back half an image further.
  const int opposite = (x + at.width - at.width / 2) % at.width;
  if (y == 0) {
    note_in_row(at, opposite, -1, revision);
  }
  if (y == at.height - 1) {
    note_in_row(at, opposite, y, revision);
  }
}

void SquareChanges::note_in_row(const Level& level, int x, int row, FilmRevision revision) {
  const auto note_square = [&](int column) {
    // Tiles share the squares at their sides, and threads that copy them all write the same.
    const std::atomic_ref<FilmRevision> changed_at(changed_at_[level.number(column, row)]);
    changed_at.store(revision, std::memory_order_relaxed);
  };
  note_square(x - 1);
  note_square(x);
  if (x == 0) {
    note_square(level.width - 1);
  }
  if (x == level.width - 1) {
    note_square(-1);
  }
}

std::array<std::uint32_t, lane_count> SquareChanges::squares(const ViewPoints& points) const {
  // The cells of the coarser level cover those of the finer one, and pixels change by level 1's.
  const Ints finer = truncated(points.level);
  const Ints coarser = finer - (points.level > floats_of(finer));
  const Ints level = coarser - (coarser < 1);
  const CellsAround at = cells_around(size_, points.image, level);
  std::array<std::uint32_t, lane_count> numbers;
  for (std::size_t i = 0; i < lane_count; ++i) {
    numbers[i] = levels_[static_cast<std::size_t>(level[i])].number(at.x[i], at.y[i]);
  }
  return numbers;
}

}  // namespace foveola
