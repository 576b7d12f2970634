#include "study/participant/cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "renderer/base/angles.h"

namespace foveola::study {
namespace {

/// Beyond this a tangent plane is too far away.
constexpr double widest_radius_deg = 75.0;

/// Into how many parts of `size` a whole is best cut.
int parts_of(double whole, double size) {
  return std::max(1, static_cast<int>(std::lround(whole / size)));
}

/// Directions of cells, gathered by patch.
class PatchSums {
 public:
  std::uint32_t add(std::uint64_t patch_key, const Vec3& direction) {
    const auto [found, is_new] =
        index_.try_emplace(patch_key, static_cast<std::uint32_t>(patches_.size()));
    if (is_new) {
      patches_.emplace_back();
    }
    patches_[found->second].direction += direction;
    ++patches_[found->second].cells;
    return found->second;
  }

  std::vector<Cells::Patch> patches() && {
    for (Cells::Patch& patch : patches_) {
      patch.direction = glm::normalize(patch.direction);
    }
    return std::move(patches_);
  }

 private:
  std::map<std::uint64_t, std::uint32_t> index_;
  std::vector<Cells::Patch> patches_;
};

std::uint64_t patch_key(int row, int column) {
  return static_cast<std::uint64_t>(row) << 32U | static_cast<std::uint32_t>(column);
}

/// Which of `parts` equal parts of [0, 1) a position lies in.
int part_at(double position, int parts) {
  return std::clamp(static_cast<int>(position * parts), 0, parts - 1);
}

double azimuth_turns(const Vec3& direction) {
  const double turns = std::atan2(direction.x, -direction.z) * (0.5 * std::numbers::inv_pi);
  return turns + 0.5;
}

}  // namespace

Cells Cells::around(const Vec3& center, double radius_deg, double cell_deg, double patch_deg) {
  Cells cells;
  const Quat level = head_orientation(azimuth_elevation(center));
  cells.cell_deg_ = cell_deg;
  cells.cell_size_ = radians(cell_deg);
  cells.right_ = level * Vec3(1.0F, 0.0F, 0.0F);
  cells.up_ = level * Vec3(0.0F, 1.0F, 0.0F);
  cells.forward_ = level * Vec3(0.0F, 0.0F, -1.0F);
  // However small the object is, the four cells around its middle belong to it.
  const double reach_rad = radians(std::clamp(radius_deg, 0.75 * cell_deg, widest_radius_deg));
  const int half = std::max(1, static_cast<int>(std::ceil(std::tan(reach_rad) / cells.cell_size_)));
  const int cells_per_patch = parts_of(patch_deg, cell_deg);
  cells.across_ = 2 * half;
  cells.cell_of_square_.assign(static_cast<std::size_t>(cells.across_) * cells.across_, none);
  PatchSums sums;
  for (int y = 0; y < cells.across_; ++y) {
    for (int x = 0; x < cells.across_; ++x) {
      const auto right = static_cast<float>((x - half + 0.5) * cells.cell_size_);
      const auto up = static_cast<float>((y - half + 0.5) * cells.cell_size_);
      if (std::atan(std::hypot(right, up)) > reach_rad) {
        continue;
      }
      const Vec3 direction = glm::normalize(cells.forward_ + right * cells.right_ + up * cells.up_);
      cells.cell_of_square_[static_cast<std::size_t>(y) * cells.across_ + x] =
          static_cast<std::uint32_t>(cells.patch_of_cell_.size());
      cells.patch_of_cell_.push_back(
          sums.add(patch_key(y / cells_per_patch, x / cells_per_patch), direction));
    }
  }
  cells.patches_ = std::move(sums).patches();
  return cells;
}

Cells Cells::everywhere(double cell_deg, double patch_deg) {
  Cells cells;
  const int rows = parts_of(180.0, cell_deg);
  const double height_deg = 180.0 / rows;
  const int rows_per_patch = parts_of(patch_deg, height_deg);
  const auto cut_at = [](double elevation_deg, double width_deg) {
    return parts_of(360.0 * std::cos(radians(elevation_deg)), width_deg);
  };
  cells.cell_deg_ = height_deg;
  PatchSums sums;
  for (int row = 0; row < rows; ++row) {
    const double elevation_deg = -90.0 + (row + 0.5) * height_deg;
    const int patch_row = row / rows_per_patch;
    const int last_row = std::min(rows, (patch_row + 1) * rows_per_patch);
    const double patch_middle_deg =
        -90.0 + 0.5 * (patch_row * rows_per_patch + last_row) * height_deg;
    const int across = cut_at(elevation_deg, height_deg);
    const int patches_across = cut_at(patch_middle_deg, rows_per_patch * height_deg);
    cells.rows_.push_back({.first_cell = static_cast<std::uint32_t>(cells.patch_of_cell_.size()),
                           .cells = static_cast<std::uint32_t>(across)});
    for (int i = 0; i < across; ++i) {
      const double turns = (i + 0.5) / across;
      const Vec3 direction = direction_from({.azimuth_rad = (turns - 0.5) * 2.0 * std::numbers::pi,
                                             .elevation_rad = radians(elevation_deg)});
      cells.patch_of_cell_.push_back(
          sums.add(patch_key(patch_row, part_at(turns, patches_across)), direction));
    }
  }
  cells.patches_ = std::move(sums).patches();
  return cells;
}

std::uint32_t Cells::at(const Vec3& direction) const {
  return across_ > 0 ? on_plane(direction) : on_sphere(direction);
}

std::uint32_t Cells::on_plane(const Vec3& direction) const {
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

std::uint32_t Cells::on_sphere(const Vec3& direction) const {
  const double elevation_turns =
      std::asin(std::clamp(direction.y, -1.0F, 1.0F)) * std::numbers::inv_pi;
  const Row& row = rows_[part_at(elevation_turns + 0.5, static_cast<int>(rows_.size()))];
  return row.first_cell + part_at(azimuth_turns(direction), static_cast<int>(row.cells));
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
  // Channels are linear in colours, so that means of colours will do.
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
