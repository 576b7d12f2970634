// A square tile of the film, written by one thread at a time: its pixels and their averages.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "renderer/film/item_pool.h"
#include "renderer/film/texel_pyramid.h"

namespace foveola {

inline constexpr std::size_t cache_line = 64;  ///< bytes

/// Counts the film's changes: added batches and clears.
using FilmRevision = std::uint32_t;

/// Calls visit(i) for the bits that are set.
template <typename Visit>
void for_each_bit(std::uint32_t word, const Visit& visit) {
  for (; word != 0; word &= word - 1) {
    visit(static_cast<std::size_t>(std::countr_zero(word)));
  }
}

/// Blocks of 8 x 8 pixels in quads of 2 x 2 are created at their first sample. At the default film
/// sizes, updates are bound by memory, so that scattered samples must touch little of it.
class FilmTile {
 public:
  static constexpr int size = 32;  ///< pixels along a side
  static constexpr int levels =
      5;  ///< levels of the pyramid above the pixels; the last is one cell

  struct Pixel {
    DVec3 sum;
    std::uint32_t count;     ///< samples in the sum
    std::uint32_t numbered;  ///< samples that were numbered

    Rgb mean() const { return count > 0 ? Rgb(sum / static_cast<double>(count)) : Rgb(0.0F); }
    PremultipliedTexel texel() const {
      return count > 0 ? PremultipliedTexel{mean(), 1.0F} : PremultipliedTexel{};
    }
  };

  /// A pixel of a tile: its block (of 16), its quad in the block (of 16), and itself in the quad.
  /// Each follows a Z-order curve, so that the four in a square are neighbours.
  class Place {
   public:
    Place() = default;
    /// x and y in [0, size).
    Place(int x, int y) : code_(static_cast<std::uint16_t>(spread(y) << 1 | spread(x))) {}
    std::size_t block() const { return code_ >> 6; }
    std::size_t quad() const { return code_ >> 2 & 15U; }
    std::size_t pixel() const { return code_ & 3U; }

   private:
    /// The five bits of a coordinate, spread with gaps.
    static int spread(int coordinate) {
      coordinate = (coordinate | coordinate << 4) & 0b1'0000'1111;
      coordinate = (coordinate | coordinate << 2) & 0b1'0011'0011;
      return (coordinate | coordinate << 1) & 0b1'0101'0101;
    }

    std::uint16_t code_ = 0;
  };

  /// The quads that received samples.
  class Touched {
   public:
    void add(Place place) {
      blocks_ |= 1U << place.block();
      quads_[place.block()] |= 1U << place.quad();
    }

   private:
    friend class FilmTile;
    std::uint32_t blocks_ = 0;               ///< one bit per block
    std::array<std::uint32_t, 16> quads_{};  ///< one bit per quad of each block
  };

 private:
  struct alignas(cache_line) Quad {
    std::array<Pixel, 4> pixels;
  };
  struct QuadWithSquares : Quad {
    std::array<double, 4> squares;
  };
  /// A square of sixteen smaller ones, and two levels of the pyramid over them.
  template <typename Child>
  struct alignas(cache_line) Node {
    std::array<Child*, 16> children;           ///< null without samples
    std::array<PremultipliedTexel, 16> means;  ///< the children's
    std::array<PremultipliedTexel, 4> quadrants;
    std::array<FilmRevision, 16> changed_at;  ///< the children's revisions; 0 without samples

    /// Updates the averages above these children, one bit each. Returns the mean of all.
    PremultipliedTexel refresh(std::uint32_t children_touched);
    /// One bit per part.
    std::uint32_t changed_after(FilmRevision since) const;
    /// Prefetches these children and their means.
    void prefetch_changed(std::uint32_t children_changed) const;
    /// Visits the means of these children as cells of `level`, the first of which lies at `corner`,
    /// and the quadrants with such children.
    template <typename Visit>
    void visit_means(std::uint32_t children_changed, int level, const IVec2& corner,
                     const Visit& visit) const;
  };
  using Block = Node<Quad>;

 public:
  /// The memory of a touched pixel, valid until the film is cleared.
  class Slot {
   public:
    Slot() = default;
    Pixel& pixel(Place place) const { return quad_->pixels[place.pixel()]; }
    /// Sum of squared luminances, in memory with squares.
    double& squares(Place place) const {
      return static_cast<QuadWithSquares*>(quad_)->squares[place.pixel()];
    }
    /// Prefetches the memory for adding to the pixel, and for averaging in its block.
    void prefetch(Place place) const {
      __builtin_prefetch(quad_);
      __builtin_prefetch(&quad_->pixels[2]);
      __builtin_prefetch(&block_->children[place.quad()]);
      __builtin_prefetch(&block_->means[place.quad()]);
      __builtin_prefetch(&block_->quadrants);
      __builtin_prefetch(&block_->changed_at);
    }

   private:
    friend class FilmTile;
    Block* block_ = nullptr;
    Quad* quad_ = nullptr;
  };

  class Memory;
  class Taker;

  /// Create a pixel, in these two steps. Each prefetches the memory of the next, which should
  /// follow a while later.
  void touch_block(Place place, Taker& memory, Slot& slot);
  static void touch_quad(Place place, Taker& memory, Slot& slot);
  /// Null if not touched.
  const Pixel* find(Place place) const;
  /// Sum of squared luminances of a touched pixel, in memory with squares.
  double squares(Place place) const {
    const Quad* quad = blocks_.children[place.block()]->children[place.quad()];
    return static_cast<const QuadWithSquares*>(quad)->squares[place.pixel()];
  }

  /// Updates the averages above `touched`, changed at `revision`. Returns the tile's mean.
  PremultipliedTexel refresh(const Touched& touched, FilmRevision revision);
  /// level in [0, levels), 0 being the pixels; x and y in [0, size >> level).
  PremultipliedTexel cell(int level, int x, int y) const;
  /// Calls visit(level, IVec2(x, y), texel) for the cells whose pixels changed after `since`; on
  /// level 0, for the pixels with samples in changed quads.
  template <typename Visit>
  void for_each_changed_cell(FilmRevision since, const Visit& visit) const;

  /// Prefetches the memory for touch_block, and for averaging over the place's block.
  void prefetch_block(Place place) const { __builtin_prefetch(&blocks_.children[place.block()]); }
  void prefetch_means(Place place) const {
    __builtin_prefetch(&blocks_.children[place.block()]);
    __builtin_prefetch(&blocks_.means[place.block()]);
    __builtin_prefetch(&blocks_.quadrants);
    __builtin_prefetch(&blocks_.changed_at);
  }

 private:
  /// Sets the first of each four bits if any of the four is set: a bit per quadrant.
  static std::uint32_t quadrants_of(std::uint32_t children) {
    const std::uint32_t pairs = children | children >> 1U;
    return (pairs | pairs >> 2U) & 0x1111U;
  }
  /// Coordinates of a part among four or sixteen, in Place's order.
  static IVec2 spot(std::size_t part) {
    const auto i = static_cast<int>(part);
    return {(i & 1) | (i >> 1 & 2), (i >> 1 & 1) | (i >> 2 & 2)};
  }
  template <typename Visit>
  static void visit_pixels(const Quad& quad, const IVec2& corner, const Visit& visit);

  Node<Block> blocks_;
};

/// Memory for the children of a film's tiles.
class FilmTile::Memory {
 public:
  /// with_squares: stores squared luminances too.
  explicit Memory(bool with_squares) : with_squares_(with_squares) {}
  /// Makes all tiles void.
  void clear();
  /// Returns at once, as HugePages::make_ready.
  void make_ready() { pages_.make_ready(); }

 private:
  friend class Taker;

  bool with_squares_;
  HugePages pages_;
  ItemPool<FilmTile> tiles_{pages_};
  ItemPool<Block> blocks_{pages_};
  ItemPool<Quad> quads_{pages_};
  ItemPool<QuadWithSquares> quads_with_squares_{pages_};
};

/// Takes items for one thread, as ItemPool::Taker.
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

inline void FilmTile::touch_block(Place place, Taker& memory, Slot& slot) {
  Block*& block = blocks_.children[place.block()];
  if (block == nullptr) {
    block = memory.take_block();
  }
  slot.block_ = block;
  __builtin_prefetch(&block->children[place.quad()]);
}

inline void FilmTile::touch_quad(Place place, Taker& memory, Slot& slot) {
  Quad*& quad = slot.block_->children[place.quad()];
  if (quad == nullptr) {
    quad = memory.take_quad();
  }
  slot.quad_ = quad;
  __builtin_prefetch(&quad->pixels[place.pixel()]);
}

template <typename Child>
std::uint32_t FilmTile::Node<Child>::changed_after(FilmRevision since) const {
  std::uint32_t changed = 0;
  for (std::uint32_t i = 0; i < changed_at.size(); ++i) {
    changed |= (changed_at[i] > since ? 1U : 0U) << i;
  }
  return changed;
}

template <typename Child>
void FilmTile::Node<Child>::prefetch_changed(std::uint32_t children_changed) const {
  __builtin_prefetch(&quadrants);
  for_each_bit(children_changed, [&](std::size_t i) {
    __builtin_prefetch(&means[i]);
    const auto* const begin = reinterpret_cast<const std::byte*>(children[i]);
    for (std::size_t offset = 0; offset < sizeof(Child); offset += cache_line) {
      __builtin_prefetch(begin + offset);
    }
  });
}

template <typename Child>
template <typename Visit>
void FilmTile::Node<Child>::visit_means(std::uint32_t children_changed, int level,
                                        const IVec2& corner, const Visit& visit) const {
  for_each_bit(quadrants_of(children_changed), [&](std::size_t first) {
    visit(level + 1, corner / 2 + spot(first / 4), quadrants[first / 4]);
  });
  for_each_bit(children_changed, [&](std::size_t i) { visit(level, corner + spot(i), means[i]); });
}

template <typename Visit>
void FilmTile::visit_pixels(const Quad& quad, const IVec2& corner, const Visit& visit) {
  for (std::size_t i = 0; i < quad.pixels.size(); ++i) {
    if (quad.pixels[i].count > 0) {
      visit(0, corner + spot(i), quad.pixels[i].texel());
    }
  }
}

// Each step runs for all blocks before the next, so that its prefetches overlap.
template <typename Visit>
void FilmTile::for_each_changed_cell(FilmRevision since, const Visit& visit) const {
  const std::uint32_t blocks_changed = blocks_.changed_after(since);
  for_each_bit(blocks_changed,
               [&](std::size_t i) { __builtin_prefetch(&blocks_.children[i]->changed_at); });
  blocks_.visit_means(blocks_changed, 3, IVec2(0), visit);
  std::array<std::uint32_t, 16> quads_changed;  // per changed block
  for_each_bit(blocks_changed, [&](std::size_t i) {
    const Block& block = *blocks_.children[i];
    quads_changed[i] = block.changed_after(since);
    block.prefetch_changed(quads_changed[i]);
  });
  for_each_bit(blocks_changed, [&](std::size_t i) {
    const Block& block = *blocks_.children[i];
    const IVec2 corner = 4 * spot(i);  // in quads
    block.visit_means(quads_changed[i], 1, corner, visit);
    for_each_bit(quads_changed[i], [&](std::size_t quad) {
      visit_pixels(*block.children[quad], 2 * (corner + spot(quad)), visit);
    });
  });
}

}  // namespace foveola
