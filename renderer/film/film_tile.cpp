#include "renderer/film/film_tile.h"

namespace foveola {
namespace {

/// The mean of four cells in a row.
PremultipliedTexel mean_of_four(const PremultipliedTexel* cells) {
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
  const Block* block = blocks_.children[place.block()];
  const Quad* quad = block != nullptr ? block->children[place.quad()] : nullptr;
  return quad != nullptr ? &quad->pixels[place.pixel()] : nullptr;
}

template <typename Child>
PremultipliedTexel FilmTile::Node<Child>::refresh(std::uint32_t children_touched) {
  for_each_bit(quadrants_of(children_touched),
               [&](std::size_t first) { quadrants[first / 4] = mean_of_four(&means[first]); });
  return mean_of_four(quadrants.data());
}

PremultipliedTexel FilmTile::refresh(const Touched& touched, FilmRevision revision) {
  for_each_bit(touched.blocks_, [&](std::size_t i) {
    Block& block = *blocks_.children[i];
    for_each_bit(touched.quads_[i], [&](std::size_t quad) {
      const std::array<Pixel, 4>& pixels = block.children[quad]->pixels;
      block.means[quad] =
          mean_of(pixels[0].texel(), pixels[1].texel(), pixels[2].texel(), pixels[3].texel());
      block.changed_at[quad] = revision;
    });
    blocks_.changed_at[i] = revision;
    blocks_.means[i] = block.refresh(touched.quads_[i]);
  });
  return blocks_.refresh(touched.blocks_);
}

PremultipliedTexel FilmTile::cell(int level, int x, int y) const {
  const Place place(x << level, y << level);
  if (level >= 3) {
    return level == 4 ? blocks_.quadrants[place.block() / 4] : blocks_.means[place.block()];
  }
  const Block* block = blocks_.children[place.block()];
  if (block == nullptr) {
    return {};
  }
  if (level >= 1) {
    return level == 2 ? block->quadrants[place.quad() / 4] : block->means[place.quad()];
  }
  const Quad* quad = block->children[place.quad()];
  return quad != nullptr ? quad->pixels[place.pixel()].texel() : PremultipliedTexel{};
}

}  // namespace foveola
