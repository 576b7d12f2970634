#include "study/participant/observer/cells.h"

#include <algorithm>
#include <map>
#include <utility>

#include "renderer/base/angles.h"

namespace foveola::study {
namespace {

/// Maximum radius of a tangent plane.
constexpr double widest_radius_deg = 75.0;

/// Returns the number of parts, of about `size`, of a whole; at least one.
int parts_of(double whole, double size) {
  return std::max(1, static_cast<int>(std::lround(whole / size)));
}

/// Coordinates of a block or a patch among others of its kind.
struct Place {
  int row = 0;
  int column = 0;
  auto operator<=>(const Place&) const = default;
};

class Gathering {
 public:
  /// Adds a cell. Returns the number of its block.
  std::uint32_t add(const Place& block, const Place& patch, const Vec3& direction) {
    const std::uint32_t patch_number = number_of(patch_numbers_, patch, patches);
    const std::uint32_t block_number = number_of(block_numbers_, {patch, block}, blocks);
    patches[patch_number].direction += direction;
    ++patches[patch_number].cells;
    blocks[block_number].patch = patch_number;
    ++blocks[block_number].cells;
    return block_number;
  }

  std::vector<Cells::Patch> patches;
  std::vector<Cells::Block> blocks;

 private:
  template <typename Key, typename Item>
  static std::uint32_t number_of(std::map<Key, std::uint32_t>& numbers, const Key& key,
                                 std::vector<Item>& items) {
    const auto [found, is_new] = numbers.try_emplace(key, static_cast<std::uint32_t>(items.size()));
    if (is_new) {
      items.emplace_back();
    }
    return found->second;
  }

  std::map<Place, std::uint32_t> patch_numbers_;
  std::map<std::pair<Place, Place>, std::uint32_t> block_numbers_;
};

}  // namespace

Cells Cells::around(const Vec3& center, double radius_deg, double cell_deg, double patch_deg,
                    int block) {
  Cells cells;
  const Quat level = head_orientation(azimuth_elevation(center));
  cells.cell_deg_ = cell_deg;
  cells.block_ = block;
  cells.cell_size_ = radians(cell_deg);
  cells.right_ = level * Vec3(1.0F, 0.0F, 0.0F);
  cells.up_ = level * Vec3(0.0F, 1.0F, 0.0F);
  cells.forward_ = level * Vec3(0.0F, 0.0F, -1.0F);
  // Even for a tiny object, the four cells around its centre belong to it.
  const double reach_rad = radians(std::clamp(radius_deg, 0.75 * cell_deg, widest_radius_deg));
  const int half = std::max(1, static_cast<int>(std::ceil(std::tan(reach_rad) / cells.cell_size_)));
  const int cells_per_patch = block * parts_of(patch_deg, block * cell_deg);
  cells.across_ = 2 * half;
  cells.cell_of_square_.assign(static_cast<std::size_t>(cells.across_) * cells.across_, none);
  Gathering gathering;
  for (int y = 0; y < cells.across_; ++y) {
    for (int x = 0; x < cells.across_; ++x) {
      const auto right = static_cast<float>((x - half + 0.5) * cells.cell_size_);
      const auto up = static_cast<float>((y - half + 0.5) * cells.cell_size_);
      if (std::atan(std::hypot(right, up)) > reach_rad) {
        continue;
      }
      const Vec3 direction = glm::normalize(cells.forward_ + right * cells.right_ + up * cells.up_);
      cells.cell_of_square_[static_cast<std::size_t>(y) * cells.across_ + x] =
          static_cast<std::uint32_t>(cells.block_of_cell_.size());
      cells.block_of_cell_.push_back(
          gathering.add({.row = y / block, .column = x / block},
                        {.row = y / cells_per_patch, .column = x / cells_per_patch}, direction));
    }
  }
  cells.store_patches(std::move(gathering.patches), std::move(gathering.blocks));
  return cells;
}

void Cells::store_patches(std::vector<Patch> patches, std::vector<Block> blocks) {
  patches_ = std::move(patches);
  blocks_ = std::move(blocks);
  for (Patch& patch : patches_) {
    patch.direction = glm::normalize(patch.direction);
  }
}

std::uint32_t Cells::at(const Vec3& direction) const {
  const double ahead = glm::dot(direction, forward_);
  if (ahead <= 0.0) {
    return none;
  }
  const double scale = 1.0 / (ahead * cell_size_);
  const double x = std::floor(glm::dot(direction, right_) * scale) + 0.5 * across_;
  const double y = std::floor(glm::dot(direction, up_) * scale) + 0.5 * across_;
  if (x < 0.0 || y < 0.0 || x >= across_ || y >= across_) {
    return none;
  }
  return cell_of_square_[static_cast<std::size_t>(y) * across_ + static_cast<std::size_t>(x)];
}

CellPixels pixels_of(const Cells& cells, const Viewport& viewport, int width, int height) {
  CellPixels pixels;
  pixels.pixels_in_cell.resize(cells.count());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec3 direction =
          viewport.direction({(static_cast<float>(x) + 0.5F) / static_cast<float>(width),
                              (static_cast<float>(y) + 0.5F) / static_cast<float>(height)});
      const std::uint32_t cell = cells.at(direction);
      if (cell != Cells::none) {
        pixels.members.push_back(
            {.pixel = static_cast<std::uint32_t>(y) * width + x, .cell = cell});
        ++pixels.pixels_in_cell[cell];
      }
    }
  }
  return pixels;
}

std::vector<ChannelValues> cell_means(const RgbImage& image, const CellPixels& pixels,
                                      double jnd_lab) {
  // Channels are linear in colours, so means of colours suffice.
  std::vector<DVec3> sums(pixels.pixels_in_cell.size(), DVec3(0.0));
  for (const CellPixels::Member& member : pixels.members) {
    sums[member.cell] += DVec3(image.pixels[member.pixel]);
  }
  std::vector<ChannelValues> means(sums.size());
  for (std::size_t cell = 0; cell < sums.size(); ++cell) {
    const double count = std::max(1U, pixels.pixels_in_cell[cell]);
    means[cell] = opponent_channels(Rgb(sums[cell] / count), jnd_lab);
  }
  return means;
}

}  // namespace foveola::study
