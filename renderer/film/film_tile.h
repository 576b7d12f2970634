// A square of the film that one thread at a time writes: its pixels and what they average to.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "renderer/film/coverage.h"

namespace foveola {

inline constexpr std::size_t cache_line = 64;  ///< bytes

/// Its blocks of 8 x 8 pixels come to life when first sampled: even a first frame whose samples lie
/// far apart touches little memory.
class alignas(cache_line) FilmTile {
  // Touched needs these.

  static constexpr int block_size = 8;
  static constexpr int blocks_across = 4;
  static constexpr std::size_t block_count = std::size_t{blocks_across} * blocks_across;
  static constexpr int squares_across = block_size / 2;

  static std::size_t block_index(int x, int y) {
    return static_cast<std::size_t>(y / block_size * blocks_across + x / block_size);
  }

 public:
  static constexpr int size = blocks_across * block_size;  ///< pixels along a side: 32
  static constexpr int levels = 5;  ///< of the pyramid above the pixels; the last is one cell

  struct Pixel {
    DVec3 sum;
    std::uint32_t count;     ///< samples in the sum
    std::uint32_t numbered;  ///< samples given a number

    Rgb mean() const { return count > 0 ? Rgb(sum / static_cast<double>(count)) : Rgb(0.0F); }
    Coverage coverage() const { return count > 0 ? Coverage{mean(), 1.0F} : Coverage{}; }
  };

  /// A set of pixels, or rather of the squares of 2 x 2 pixels that they lie in.
  class Touched {
   public:
    void add(int x, int y) {
      const int square = y % block_size / 2 * squares_across + x % block_size / 2;
      squares_[block_index(x, y)] |= 1U << square;
    }

   private:
    friend class FilmTile;
    std::array<std::uint32_t, block_count> squares_{};  ///< of each block, a bit for each
  };

  /// Forgets all samples if they are from before `epoch`.
  void enter(std::uint32_t epoch);
  std::uint32_t epoch() const { return epoch_; }

  /// x and y in [0, size). Brings the pixel's block to life, with squares of luminance if asked.
  Pixel& touch(int x, int y, bool with_squares);
  /// A pixel that was touched.
  Pixel& at(int x, int y) { return block_of(x, y)->pixels[index_in_block(x, y)]; }
  /// Null if it was not touched.
  const Pixel* find(int x, int y) const;
  /// The sum of the squared luminances of a pixel that was touched with squares.
  double& squares(int x, int y) { return (*block_of(x, y)->squares)[index_in_block(x, y)]; }
  double squares(int x, int y) const { return (*block_of(x, y)->squares)[index_in_block(x, y)]; }

  /// Averages anew what lies above `touched`.
  void refresh(const Touched& touched);
  /// level in [0, levels], 0 being the pixels; x and y in [0, size >> level).
  Coverage cell(int level, int x, int y) const;

 private:
  /// Aligned so that no pixel and no four cells straddle two cache lines: at a film's usual sizes
  /// its updates take as long as its memory does.
  struct alignas(cache_line) Block {
    static constexpr std::size_t pixel_count = std::size_t{block_size} * block_size;
    // Memory is not worth clearing for the few pixels that a first frame touches: what the bits
    // below do not vouch for is void.
    std::array<Pixel, pixel_count> pixels;
    std::array<Coverage, pixel_count / 4> level1;
    std::array<Coverage, pixel_count / 16> level2;
    std::unique_ptr<std::array<double, pixel_count>> squares;
    std::uint64_t touched = 0;   ///< a bit for each pixel
    std::uint32_t averaged = 0;  ///< a bit for each cell of level 1

    bool is_touched(std::size_t pixel) const { return (touched >> pixel & 1U) != 0; }
    Coverage coverage(std::size_t pixel) const {
      return is_touched(pixel) ? pixels[pixel].coverage() : Coverage{};
    }
    Coverage level1_cell(std::size_t cell) const {
      return (averaged >> cell & 1U) != 0 ? level1[cell] : Coverage{};
    }
    Coverage level2_cell(std::size_t cell) const;
    /// Averages anew what lies above the squares whose bits are set.
    void refresh(std::uint32_t squares_touched);
  };

  static std::size_t index_in_block(int x, int y) {
    return static_cast<std::size_t>(y % block_size * block_size + x % block_size);
  }
  const std::unique_ptr<Block>& block_of(int x, int y) const { return blocks_[block_index(x, y)]; }
  /// Null where it is not alive.
  const Block* living_block(int x, int y) const {
    const std::size_t index = block_index(x, y);
    return (alive_ >> index & 1U) != 0 ? blocks_[index].get() : nullptr;
  }

  std::array<std::unique_ptr<Block>, block_count> blocks_;
  std::array<Coverage, block_count> level3_{};
  std::array<Coverage, block_count / 4> level4_{};
  Coverage level5_;
  std::uint32_t epoch_ = 0;
  std::uint32_t alive_ = 0;  ///< a bit for each block
};

}  // namespace foveola
