// Where the pixels of a view lie on the equirect image, and how large they are on it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/film/shown_color.h"
#include "renderer/view/viewport.h"

namespace foveola {

/// The numbers of eight pixels of a view, row by row.
using EightPixels = std::array<std::uint32_t, lane_count>;

/// What is known of a view of width x height pixels: positions, which turn with the head, and
/// levels, which depend on the lens and the fields of view alone. Different rows may be worked out
/// at the same time.
class ViewPixels {
 public:
  ViewPixels(int width, int height);
  std::uint32_t count() const { return static_cast<std::uint32_t>(width_) * height_; }

  /// Works out the positions in the rows [begin, end).
  void place(const Viewport& viewport, int begin, int end);
  /// Works out the levels, for a pyramid over an equirect image of `image_height` pixels: those
  /// whose cells are as high as a pixel of the view is wide. Towards the poles cells become
  /// narrower than that: taking a coarser level would blur upwards and downwards.
  void choose_levels(const Viewport& viewport, int image_height, int last_level, int begin,
                     int end);

  float highest_level() const;
  ViewPoints points(const EightPixels& pixels) const;
  /// The points of the eight pixels from `first` on; beyond the last pixel they lie where that
  /// does, on some level.
  ViewPoints points_from(std::size_t first) const;

 private:
  Vec2 middle_of(int x, int y) const {
    return {(static_cast<float>(x) + 0.5F) / static_cast<float>(width_),
            (static_cast<float>(y) + 0.5F) / static_cast<float>(height_)};
  }
  std::size_t row(int y) const { return static_cast<std::size_t>(y) * width_; }

  int width_;
  int height_;
  std::vector<float> u_;
  std::vector<float> v_;
  std::vector<float> level_;
};

/// The level, in between two of them perhaps, whose cells are as high as a patch of `sr` steradians
/// is wide, over an equirect image of `image_height` pixels. At least 0.
float level_for(double sr, int image_height);

}  // namespace foveola
