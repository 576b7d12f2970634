// A square of the film that one thread at a time writes: its pixels and what they average to.
#pragma once

#include <array>
#include <cstdint>

#include "renderer/film/coverage.h"
#include "renderer/film/item_pool.h"

namespace foveola {

inline constexpr std::size_t cache_line = 64;  ///< bytes

/// Blocks of 8 x 8 pixels, made of quads of 2 x 2, come to life when first sampled: at a film's
/// usual sizes its updates take as long as its memory does, so samples that lie far apart must
/// touch little of it.
class alignas(cache_line) FilmTile {
 public:
  static constexpr int size = 32;   ///< pixels along a side
  static constexpr int levels = 5;  ///< of the pyramid above the pixels; the last is one cell

  struct Pixel {
    DVec3 sum;
    std::uint32_t count;     ///< samples in the sum
    std::uint32_t numbered;  ///< samples given a number

    Rgb mean() const { return count > 0 ? Rgb(sum / static_cast<double>(count)) : Rgb(0.0F); }
    Coverage coverage() const { return count > 0 ? Coverage{mean(), 1.0F} : Coverage{}; }
  };

  /// A pixel of a tile: its block (of 16, row by row), its quad in the block (of 16, along a
  /// Z-order curve so that the four under a cell of level 2 are neighbours), itself in the quad.
  class Place {
   public:
    Place() = default;
    /// x and y in [0, size).
    Place(int x, int y)
        : code_(static_cast<std::uint16_t>((y >> 3) << 8 | (x >> 3) << 6 | bit(y, 2) << 5 |
                                           bit(x, 2) << 4 | bit(y, 1) << 3 | bit(x, 1) << 2 |
                                           bit(y, 0) << 1 | bit(x, 0))) {}
    std::size_t block() const { return code_ >> 6; }
    std::size_t quad() const { return code_ >> 2 & 15U; }
    std::size_t pixel() const { return code_ & 3U; }

   private:
    static int bit(int number, int index) { return number >> index & 1; }

    std::uint16_t code_ = 0;
  };

  /// Quads that samples fell in.
  class Touched {
   public:
    void add(Place place) { quads_[place.block()] |= 1U << place.quad(); }

   private:
    friend class FilmTile;
    std::array<std::uint32_t, 16> quads_{};  ///< of each block, a bit for each
  };

 private:
  struct alignas(cache_line) Quad {
    std::array<Pixel, 4> pixels;
  };
  struct QuadWithSquares : Quad {
    std::array<double, 4> squares;
  };
  struct alignas(cache_line) Block {
    std::array<Quad*, 16> quads;
    std::array<Coverage, 16> level1;
    std::array<Coverage, 4> level2;
  };

 public:
  /// Where the parts of a film's tiles come from.
  class Memory {
   public:
    /// with_squares: keep the squares of luminances too.
    explicit Memory(bool with_squares) : with_squares_(with_squares) {}
    /// For what `samples` samples may bring to life.
    void reserve(std::size_t samples);
    FilmTile* take_tile() { return tiles_.take(); }
    /// All tiles are void from now on.
    void clear();

   private:
    friend class FilmTile;
    Block* take_block() { return blocks_.take(); }
    Quad* take_quad() { return with_squares_ ? quads_with_squares_.take() : quads_.take(); }

    bool with_squares_;
    ItemPool<FilmTile> tiles_;
    ItemPool<Block> blocks_;
    ItemPool<Quad> quads_;
    ItemPool<QuadWithSquares> quads_with_squares_;
  };

  /// Brings the pixel to life.
  Pixel& touch(Place place, Memory& memory);
  /// A pixel that was touched.
  Pixel& at(Place place) { return quad_at(place)->pixels[place.pixel()]; }
  /// Null if it was not touched.
  const Pixel* find(Place place) const;
  /// The sum of the squared luminances of a pixel that was touched, in memory with squares.
  double& squares(Place place) {
    return static_cast<QuadWithSquares*>(quad_at(place))->squares[place.pixel()];
  }
  double squares(Place place) const {
    return static_cast<const QuadWithSquares*>(quad_at(place))->squares[place.pixel()];
  }

  /// Averages anew what lies above `touched`.
  void refresh(const Touched& touched);
  /// level in [0, levels], 0 being the pixels; x and y in [0, size >> level).
  Coverage cell(int level, int x, int y) const;

  /// Ask for the memory that the next step, or touching and averaging a pixel, will need. In this
  /// order, each a while after the other, since each looks into what the one before asked for.
  void prefetch() const {
    __builtin_prefetch(this);
    __builtin_prefetch(&blocks_[8]);
  }
  void prefetch_block(Place place) const;
  void prefetch_pixel(Place place) const;

 private:
  Quad* quad_at(Place place) const { return blocks_[place.block()]->quads[place.quad()]; }

  std::array<Block*, 16> blocks_{};
  std::array<Coverage, 16> level3_{};
  std::array<Coverage, 4> level4_{};
  Coverage level5_;
};

}  // namespace foveola
