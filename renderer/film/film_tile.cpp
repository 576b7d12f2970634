#include "renderer/film/film_tile.h"

#include <bit>

namespace foveola {
namespace {

/// Calls visit(i) for the bits that are set.
template <typename Visit>
void for_each_bit(std::uint32_t word, const Visit& visit) {
  for (; word != 0; word &= word - 1) {
    visit(static_cast<std::size_t>(std::countr_zero(word)));
  }
}

/// Of four cells in a row.
Coverage mean_of_four(const Coverage* cells) {
  return mean_of(cells[0], cells[1], cells[2], cells[3]);
}

}  // namespace

void FilmTile::Memory::reserve(std::size_t samples) {
  tiles_.reserve(samples);
  blocks_.reserve(samples);
  if (with_squares_) {
    quads_with_squares_.reserve(samples);
  } else {
    quads_.reserve(samples);
  }
}

void FilmTile::Memory::clear() {
  tiles_.clear();
  blocks_.clear();
  quads_.clear();
  quads_with_squares_.clear();
}

FilmTile::Pixel& FilmTile::touch(Place place, Memory& memory) {
  Block*& block = blocks_[place.block()];
  if (block == nullptr) {
    block = memory.take_block();
  }
  Quad*& quad = block->quads[place.quad()];
  if (quad == nullptr) {
    quad = memory.take_quad();
  }
  return quad->pixels[place.pixel()];
}

const FilmTile::Pixel* FilmTile::find(Place place) const {
  const Block* block = blocks_[place.block()];
  const Quad* quad = block != nullptr ? block->quads[place.quad()] : nullptr;
  return quad != nullptr ? &quad->pixels[place.pixel()] : nullptr;
}

void FilmTile::refresh(const Touched& touched) {
  std::uint32_t touched4 = 0;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    if (touched.quads_[i] == 0) {
      continue;
    }
    Block& block = *blocks_[i];
    std::uint32_t touched2 = 0;
    for_each_bit(touched.quads_[i], [&](std::size_t quad) {
      const std::array<Pixel, 4>& pixels = block.quads[quad]->pixels;
      block.level1[quad] = mean_of(pixels[0].coverage(), pixels[1].coverage(), pixels[2].coverage(),
                                   pixels[3].coverage());
      touched2 |= 1U << quad / 4;
    });
    for_each_bit(touched2, [&](std::size_t cell) {
      block.level2[cell] = mean_of_four(&block.level1[4 * cell]);
    });
    level3_[i] = mean_of_four(block.level2.data());
    touched4 |= 1U << (i / 8 * 2 + i % 4 / 2);
  }
  for_each_bit(touched4, [&](std::size_t cell) {
    const Coverage* corner = &level3_[cell / 2 * 8 + cell % 2 * 2];
    level4_[cell] = mean_of(corner[0], corner[1], corner[4], corner[5]);
  });
  level5_ = mean_of_four(level4_.data());
}

Coverage FilmTile::cell(int level, int x, int y) const {
  if (level >= 3) {
    const auto index = static_cast<std::size_t>(y * (size >> level) + x);
    return level == 3 ? level3_[index] : level == 4 ? level4_[index] : level5_;
  }
  const Place place(x << level, y << level);
  if (level == 0) {
    const Pixel* pixel = find(place);
    return pixel != nullptr ? pixel->coverage() : Coverage{};
  }
  const Block* block = blocks_[place.block()];
  if (block == nullptr) {
    return {};
  }
  return level == 1 ? block->level1[place.quad()] : block->level2[place.quad() / 4];
}

void FilmTile::prefetch_block(Place place) const {
  const Block* block = blocks_[place.block()];
  if (block != nullptr) {
    __builtin_prefetch(&block->quads[place.quad()]);
    __builtin_prefetch(&block->level1[place.quad()]);
    __builtin_prefetch(&block->level2);
  }
}

void FilmTile::prefetch_pixel(Place place) const {
  const Block* block = blocks_[place.block()];
  if (block != nullptr && block->quads[place.quad()] != nullptr) {
    const Quad* quad = block->quads[place.quad()];
    __builtin_prefetch(quad);
    __builtin_prefetch(&quad->pixels[2]);
  }
}

}  // namespace foveola
