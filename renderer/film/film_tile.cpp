#include "renderer/film/film_tile.h"

namespace foveola {
namespace {

/// Of four cells in a row.
Coverage mean_of_four(const Coverage* cells) {
  return mean_of(cells[0], cells[1], cells[2], cells[3]);
}

}  // namespace

void FilmTile::Memory::clear() {
  tiles_.clear();
  blocks_.clear();
  quads_.clear();
  quads_with_squares_.clear();
}

const FilmTile::Pixel* FilmTile::find(Place place) const {
  const Block* block = blocks_.parts[place.block()];
  const Quad* quad = block != nullptr ? block->parts[place.quad()] : nullptr;
  return quad != nullptr ? &quad->pixels[place.pixel()] : nullptr;
}

template <typename Part>
Coverage FilmTile::Sixteen<Part>::refresh(std::uint32_t parts_touched) {
  for_each_bit(quarters_of(parts_touched),
               [&](std::size_t first) { quarters[first / 4] = mean_of_four(&means[first]); });
  return mean_of_four(quarters.data());
}

Coverage FilmTile::refresh(const Touched& touched, FilmRevision revision) {
  for_each_bit(touched.blocks_, [&](std::size_t i) {
    Block& block = *blocks_.parts[i];
    for_each_bit(touched.quads_[i], [&](std::size_t quad) {
      const std::array<Pixel, 4>& pixels = block.parts[quad]->pixels;
      block.means[quad] = mean_of(pixels[0].coverage(), pixels[1].coverage(), pixels[2].coverage(),
                                  pixels[3].coverage());
      block.changed_at[quad] = revision;
    });
    blocks_.changed_at[i] = revision;
    blocks_.means[i] = block.refresh(touched.quads_[i]);
  });
  return blocks_.refresh(touched.blocks_);
}

Coverage FilmTile::cell(int level, int x, int y) const {
  const Place place(x << level, y << level);
  if (level >= 3) {
    return level == 4 ? blocks_.quarters[place.block() / 4] : blocks_.means[place.block()];
  }
  const Block* block = blocks_.parts[place.block()];
  if (block == nullptr) {
    return {};
  }
  if (level >= 1) {
    return level == 2 ? block->quarters[place.quad() / 4] : block->means[place.quad()];
  }
  const Quad* quad = block->parts[place.quad()];
  return quad != nullptr ? quad->pixels[place.pixel()].coverage() : Coverage{};
}

}  // namespace foveola
