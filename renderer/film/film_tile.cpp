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

}  // namespace

void FilmTile::enter(std::uint32_t epoch) {
  if (epoch_ != epoch) {
    epoch_ = epoch;
    alive_ = 0;
    level3_.fill({});
    level4_.fill({});
    level5_ = {};
  }
}

FilmTile::Pixel& FilmTile::touch(int x, int y, bool with_squares) {
  const std::size_t index = block_index(x, y);
  std::unique_ptr<Block>& block = blocks_[index];
  if ((alive_ >> index & 1U) == 0) {
    alive_ |= 1U << index;
    if (!block) {
      block = std::make_unique_for_overwrite<Block>();
      if (with_squares) {
        block->squares = std::make_unique_for_overwrite<std::array<double, Block::pixel_count>>();
      }
    }
    block->touched = 0;
    block->averaged = 0;
  }
  const std::size_t pixel = index_in_block(x, y);
  if (!block->is_touched(pixel)) {
    block->touched |= std::uint64_t{1} << pixel;
    block->pixels[pixel] = {};
    if (block->squares) {
      (*block->squares)[pixel] = 0.0;
    }
  }
  return block->pixels[pixel];
}

const FilmTile::Pixel* FilmTile::find(int x, int y) const {
  const Block* block = living_block(x, y);
  const std::size_t pixel = index_in_block(x, y);
  return block != nullptr && block->is_touched(pixel) ? &block->pixels[pixel] : nullptr;
}

Coverage FilmTile::Block::level2_cell(std::size_t cell) const {
  constexpr std::size_t across = squares_across;
  // Two neighbouring cells of level 1 in each of two rows.
  constexpr std::uint32_t below = 3U | 3U << across;
  const bool is_averaged = (averaged >> (cell / 2 * 2 * across + cell % 2 * 2) & below) != 0;
  return is_averaged ? level2[cell] : Coverage{};
}

void FilmTile::Block::refresh(std::uint32_t squares_touched) {
  constexpr std::size_t across = squares_across;
  std::uint32_t touched2 = 0;
  for_each_bit(squares_touched, [&](std::size_t square) {
    const std::size_t x = square % across;
    const std::size_t y = square / across;
    const std::size_t corner = 2 * y * block_size + 2 * x;
    level1[square] = mean_of(coverage(corner), coverage(corner + 1), coverage(corner + block_size),
                             coverage(corner + block_size + 1));
    touched2 |= 1U << (y / 2 * (across / 2) + x / 2);
  });
  averaged |= squares_touched;
  for_each_bit(touched2, [&](std::size_t cell) {
    const std::size_t corner = cell / 2 * 2 * across + cell % 2 * 2;
    level2[cell] = mean_of(level1_cell(corner), level1_cell(corner + 1),
                           level1_cell(corner + across), level1_cell(corner + across + 1));
  });
}

void FilmTile::refresh(const Touched& touched) {
  constexpr std::size_t across = blocks_across;
  std::uint32_t touched4 = 0;
  for (std::size_t block = 0; block < block_count; ++block) {
    if (touched.squares_[block] != 0) {
      blocks_[block]->refresh(touched.squares_[block]);
      const Block& averaged = *blocks_[block];
      level3_[block] = mean_of(averaged.level2_cell(0), averaged.level2_cell(1),
                               averaged.level2_cell(2), averaged.level2_cell(3));
      touched4 |= 1U << (block / across / 2 * (across / 2) + block % across / 2);
    }
  }
  for_each_bit(touched4, [&](std::size_t cell) {
    const Coverage* corner = &level3_[cell / 2 * 2 * across + cell % 2 * 2];
    level4_[cell] = mean_of(corner[0], corner[1], corner[across], corner[across + 1]);
  });
  level5_ = mean_of(level4_[0], level4_[1], level4_[2], level4_[3]);
}

Coverage FilmTile::cell(int level, int x, int y) const {
  const auto index = [](int column, int row, int across) {
    return static_cast<std::size_t>(row * across + column);
  };
  if (level >= 3) {
    return level == 3   ? level3_[index(x, y, blocks_across)]
           : level == 4 ? level4_[index(x, y, blocks_across / 2)]
                        : level5_;
  }
  const Block* block = living_block(x << level, y << level);
  if (block == nullptr) {
    return {};
  }
  const int across = block_size >> level;
  const std::size_t cell = index(x % across, y % across, across);
  return level == 0   ? block->coverage(cell)
         : level == 1 ? block->level1_cell(cell)
                      : block->level2_cell(cell);
}

}  // namespace foveola
