// Divides a view for judging: pixels into cells, each judged by its mean; cells into blocks whose
// noise is judged together (of one cell, except in scaled studies); blocks into patches, each with
// one eccentricity.
//
// Cells lie on the world, not on the display, so that a judgement does not depend on the display's
// pixels, nor on the film's. A cell's value is the mean of its pixels' values in each channel.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "renderer/image/image.h"
#include "renderer/view/viewport.h"
#include "study/participant/observer/visibility.h"
#include "study/participant/population.h"

namespace foveola::study {

/// A part of the view that is divided into square cells, and these into patches.
class Cells {
 public:
  /// Returns the cells within radius_deg of `center` (unit length, world): a square grid on the
  /// tangent plane there, level with the horizon. A cell belongs to it if its centre does.
  /// patch_deg is rounded to a whole number of blocks, of block x block cells each, but at least
  /// one.
  static Cells around(const Vec3& center, double radius_deg, double cell_deg, double patch_deg,
                      int block = 1);

  struct Patch {
    Vec3 direction{0.0F};     ///< Direction of its centre; unit length, world.
    std::uint32_t cells = 0;  ///< Number of its cells.
  };
  const std::vector<Patch>& patches() const { return patches_; }
  /// A block of cells in one patch; at edges it may have fewer cells.
  struct Block {
    std::uint32_t patch = 0;
    std::uint32_t cells = 0;
  };
  const std::vector<Block>& blocks() const { return blocks_; }
  /// Number of cells of a complete block.
  int cells_of_whole_block() const { return block_ * block_; }
  double cell_deg() const { return cell_deg_; }
  /// Returns the angle from the centre to the nearest edge of the square that holds all cells.
  double half_width_rad() const { return std::atan(0.5 * across_ * cell_size_); }
  std::size_t count() const { return block_of_cell_.size(); }
  std::uint32_t block_of(std::uint32_t cell) const { return block_of_cell_[cell]; }
  std::uint32_t patch_of(std::uint32_t cell) const { return blocks_[block_of(cell)].patch; }

  static constexpr std::uint32_t none = 0xffffffffU;
  /// Returns the index of the cell that contains `direction` (unit length, world), or none.
  std::uint32_t at(const Vec3& direction) const;

 private:
  Cells() = default;
  /// Stores the blocks, and the patches, which come with the sums of their cells' directions.
  void store_patches(std::vector<Patch> patches, std::vector<Block> blocks);

  double cell_deg_ = 0.0;
  int block_ = 1;
  std::vector<Patch> patches_;
  std::vector<Block> blocks_;
  std::vector<std::uint32_t> block_of_cell_;
  // The grid on a tangent plane.
  int across_ = 0;
  double cell_size_ = 0.0;  ///< On the plane at distance 1.
  Vec3 right_{0.0F};
  Vec3 up_{0.0F};
  Vec3 forward_{0.0F};
  std::vector<std::uint32_t> cell_of_square_;
};

/// The pixels of a view that lie in cells.
struct CellPixels {
  struct Member {
    std::uint32_t pixel = 0;  ///< Index into the image.
    std::uint32_t cell = 0;
  };
  std::vector<Member> members;
  std::vector<std::uint32_t> pixels_in_cell;
};
CellPixels pixels_of(const Cells& cells, const Viewport& viewport, int width, int height);

/// Returns the means of cells in an sRGB-encoded image; 0 for cells without pixels.
std::vector<ChannelValues> cell_means(const RgbImage& image, const CellPixels& pixels,
                                      double jnd_lab);

}  // namespace foveola::study
