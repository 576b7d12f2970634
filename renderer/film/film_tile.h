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
class FilmTile {
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

  /// A pixel of a tile: its block (of 16), its quad in the block (of 16), itself in the quad; each
  /// along a Z-order curve, so that the four in a square are neighbours.
  class Place {
   public:
    Place() = default;
    /// x and y in [0, size).
    Place(int x, int y) : code_(static_cast<std::uint16_t>(spread(y) << 1 | spread(x))) {}
    std::size_t block() const { return code_ >> 6; }
    std::size_t quad() const { return code_ >> 2 & 15U; }
    std::size_t pixel() const { return code_ & 3U; }

   private:
    /// The five bits of a coordinate with gaps between them.
    static int spread(int coordinate) {
      coordinate = (coordinate | coordinate << 4) & 0b1'0000'1111;
      coordinate = (coordinate | coordinate << 2) & 0b1'0011'0011;
      return (coordinate | coordinate << 1) & 0b1'0101'0101;
    }

    std::uint16_t code_ = 0;
  };

  /// Quads that samples fell in.
  class Touched {
   public:
    void add(Place place) {
      blocks_ |= 1U << place.block();
      quads_[place.block()] |= 1U << place.quad();
    }

   private:
    friend class FilmTile;
    std::uint32_t blocks_ = 0;               ///< a bit for each
    std::array<std::uint32_t, 16> quads_{};  ///< of each block, likewise
  };

 private:
  struct alignas(cache_line) Quad {
    std::array<Pixel, 4> pixels;
  };
  struct QuadWithSquares : Quad {
    std::array<double, 4> squares;
  };
  /// A square of sixteen smaller ones, and two levels of the pyramid over them.
  template <typename Part>
  struct alignas(cache_line) Sixteen {
    std::array<Part*, 16> parts;     ///< null where nothing was sampled
    std::array<Coverage, 16> means;  ///< of the parts
    std::array<Coverage, 4> quarters;

    /// Averages anew what lies above these parts, a bit for each. Returns the mean of all.
    Coverage refresh(std::uint32_t parts_touched);
  };
  using Block = Sixteen<Quad>;

 public:
  /// Where a pixel that was touched lies in memory, until that is cleared.
  class Home {
   public:
    Home() = default;
    Pixel& pixel(Place place) const { return quad_->pixels[place.pixel()]; }
    /// The sum of the squared luminances, in memory with squares.
    double& squares(Place place) const {
      return static_cast<QuadWithSquares*>(quad_)->squares[place.pixel()];
    }
    /// Asks for the memory that adding to the pixel, and averaging in its block, will need.
    void prefetch(Place place) const {
      __builtin_prefetch(quad_);
      __builtin_prefetch(&quad_->pixels[2]);
      __builtin_prefetch(&block_->parts[place.quad()]);
      __builtin_prefetch(&block_->means[place.quad()]);
      __builtin_prefetch(&block_->quarters);
    }

   private:
    friend class FilmTile;
    Block* block_ = nullptr;
    Quad* quad_ = nullptr;
  };

  class Memory;
  class Taker;

  /// Bring a pixel to life, in these two steps. Each asks for the memory that the next one needs,
  /// which should follow a while later.
  void touch_block(Place place, Taker& memory, Home& home);
  static void touch_quad(Place place, Taker& memory, Home& home);
  /// Null if it was not touched.
  const Pixel* find(Place place) const;
  /// The sum of the squared luminances of a pixel that was touched, in memory with squares.
  double squares(Place place) const {
    const Quad* quad = blocks_.parts[place.block()]->parts[place.quad()];
    return static_cast<const QuadWithSquares*>(quad)->squares[place.pixel()];
  }

  /// Averages anew what lies above `touched`. Returns the mean of the tile.
  Coverage refresh(const Touched& touched);
  /// level in [0, levels), 0 being the pixels; x and y in [0, size >> level).
  Coverage cell(int level, int x, int y) const;

  /// Ask for the memory that touch_block, and averaging over the place's block, will need.
  void prefetch_block(Place place) const { __builtin_prefetch(&blocks_.parts[place.block()]); }
  void prefetch_means(Place place) const {
    __builtin_prefetch(&blocks_.parts[place.block()]);
    __builtin_prefetch(&blocks_.means[place.block()]);
    __builtin_prefetch(&blocks_.quarters);
  }

 private:
  Sixteen<Block> blocks_;
};

/// Where the parts of a film's tiles come from.
class FilmTile::Memory {
 public:
  /// with_squares: keep the squares of luminances too.
  explicit Memory(bool with_squares) : with_squares_(with_squares) {}
  /// All tiles are void from now on.
  void clear();

 private:
  friend class Taker;

  bool with_squares_;
  ItemPool<FilmTile> tiles_;
  ItemPool<Block> blocks_;
  ItemPool<Quad> quads_;
  ItemPool<QuadWithSquares> quads_with_squares_;
};

/// Takes them for one thread, as ItemPool::Taker.
class FilmTile::Taker {
 public:
  explicit Taker(Memory& memory)
      : with_squares_(memory.with_squares_),
        tiles_(memory.tiles_),
        blocks_(memory.blocks_),
        quads_(memory.quads_),
        quads_with_squares_(memory.quads_with_squares_) {}

  FilmTile* take_tile() { return tiles_.take(); }

 private:
  friend class FilmTile;
  Block* take_block() { return blocks_.take(); }
  Quad* take_quad() { return with_squares_ ? quads_with_squares_.take() : quads_.take(); }

  bool with_squares_;
  ItemPool<FilmTile>::Taker tiles_;
  ItemPool<Block>::Taker blocks_;
  ItemPool<Quad>::Taker quads_;
  ItemPool<QuadWithSquares>::Taker quads_with_squares_;
};

inline void FilmTile::touch_block(Place place, Taker& memory, Home& home) {
  Block*& block = blocks_.parts[place.block()];
  if (block == nullptr) {
    block = memory.take_block();
  }
  home.block_ = block;
  __builtin_prefetch(&block->parts[place.quad()]);
}

inline void FilmTile::touch_quad(Place place, Taker& memory, Home& home) {
  Quad*& quad = home.block_->parts[place.quad()];
  if (quad == nullptr) {
    quad = memory.take_quad();
  }
  home.quad_ = quad;
  __builtin_prefetch(&quad->pixels[place.pixel()]);
}

}  // namespace foveola
