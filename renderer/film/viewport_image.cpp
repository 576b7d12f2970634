#include "renderer/film/viewport_image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "renderer/view/equirect.h"

namespace foveola {
namespace {

/// Rows of the view that one task makes.
constexpr std::size_t row_block = 16;

/// A level of a pyramid over an equirect image, both sides in cells.
template <typename Pyramid>
class Level {
 public:
  Level(const Pyramid& pyramid, int level)
      : pyramid_(pyramid),
        level_(level),
        width_(pyramid.width(level)),
        height_(pyramid.height(level)),
        scale_(Vec2(pyramid.width(0), pyramid.height(0)) / static_cast<float>(1 << level)) {}

  /// The bilinear mean of the four cells around `image`.
  Coverage bilinear(const Vec2& image) const {
    const Vec2 place = image * scale_ - 0.5F;
    const Vec2 corner = glm::floor(place);
    const Vec2 t = place - corner;
    const int x = static_cast<int>(corner.x);
    const int y = static_cast<int>(corner.y);
    Coverage sum = (1.0F - t.x) * (1.0F - t.y) * wrapped(x, y);
    sum += t.x * (1.0F - t.y) * wrapped(x + 1, y);
    sum += (1.0F - t.x) * t.y * wrapped(x, y + 1);
    sum += t.x * t.y * wrapped(x + 1, y + 1);
    return sum;
  }

 private:
  /// x may lie beyond the seam, and y beyond a pole: over the pole the same row comes back half an
  /// image further.
  Coverage wrapped(int x, int y) const {
    if (y < 0 || y >= height_) {
      y = y < 0 ? -1 - y : 2 * height_ - 1 - y;
      x += width_ / 2;
    }
    if (x < 0) {
      x += width_;
    } else if (x >= width_) {
      x -= width_;
    }
    return pyramid_.cell(level_, x, y);
  }

  const Pyramid& pyramid_;
  int level_;
  int width_;
  int height_;
  Vec2 scale_;  ///< cells over the image's sides, which the last cell may reach beyond
};

/// An image whose pixels are all known, as a pyramid.
class PanoramaPyramid {
 public:
  PanoramaPyramid(const RgbImage& panorama, int most_levels)
      : levels_(panorama.width, panorama.height, most_levels) {
    for (std::uint32_t i = 0; i < panorama.pixels.size(); ++i) {
      levels_.finest(i) = {panorama.pixels[i], 1.0F};
    }
    levels_.refresh_all();
  }

  int levels() const { return levels_.count(); }
  int width(int level) const { return levels_.width(level); }
  int height(int level) const { return levels_.height(level); }
  Coverage cell(int level, int x, int y) const { return levels_.cell(level, x, y); }

 private:
  CoverageLevels levels_;
};

/// The level, in between two of them perhaps, whose cells are as high as a patch of `sr` steradians
/// is wide. Towards the poles cells become narrower than that: taking a coarser level would blur
/// upwards and downwards.
float level_for(double sr, int film_height) {
  const double cell_rad = std::numbers::pi / film_height;
  return static_cast<float>(std::max(0.0, std::log2(std::sqrt(sr) / cell_rad)));
}

/// Resamples a pyramid to a view.
template <typename Pyramid>
class Resampler {
 public:
  Resampler(const Pyramid& pyramid, const Viewport& viewport, RgbImage& view,
            UnsampledPixels unsampled)
      : pyramid_(pyramid), viewport_(viewport), view_(view), unsampled_(unsampled) {
    for (int level = 0; level < pyramid.levels(); ++level) {
      levels_.emplace_back(pyramid, level);
    }
  }

  /// The rows [begin, end).
  void resample(int begin, int end) const {
    const double pixels = static_cast<double>(view_.width) * view_.height;
    for (int y = begin; y < end; ++y) {
      for (int x = 0; x < view_.width; ++x) {
        const Vec2 plane((static_cast<float>(x) + 0.5F) / static_cast<float>(view_.width),
                         (static_cast<float>(y) + 0.5F) / static_cast<float>(view_.height));
        const float level = level_for(viewport_.sr_per_area(plane) / pixels, pyramid_.height(0));
        view_.at(x, y) = color(equirect_from_direction(viewport_.direction(plane)), level);
      }
    }
  }

 private:
  Rgb color(const Vec2& image, float level) const {
    const float last = static_cast<float>(levels_.size() - 1);
    const auto finer = static_cast<std::size_t>(std::min(level, last));
    const float t = std::min(level, last) - static_cast<float>(finer);
    Coverage known = levels_[finer].bilinear(image);
    if (t > 0.0F) {
      known = (1.0F - t) * known;
      known += t * levels_[finer + 1].bilinear(image);
    }
    if (unsampled_ == UnsampledPixels::filled) {
      fill(image, finer + 1, known);
    }
    return known.weight > 0.0F ? known.color / known.weight : Rgb(0.0F);
  }

  /// Lets coarser levels, one after the other, make up for what `known` lacks. One known pixel
  /// stands for its whole cell (as in Grossman and Dally 1998, "Point Sample Rendering").
  void fill(const Vec2& image, std::size_t first_level, Coverage& known) const {
    constexpr float enough = 0.999F;
    for (std::size_t level = first_level; level < levels_.size() && known.weight < enough;
         ++level) {
      const Coverage coarser = levels_[level].bilinear(image);
      if (coarser.weight > 0.0F) {
        const float pixels_in_cell = std::exp2(2.0F * static_cast<float>(level));
        known += (1.0F - known.weight) * std::min(pixels_in_cell, 1.0F / coarser.weight) * coarser;
      }
    }
  }

  const Pyramid& pyramid_;
  const Viewport& viewport_;
  RgbImage& view_;
  UnsampledPixels unsampled_;
  std::vector<Level<Pyramid>> levels_;
};

}  // namespace

RgbImage viewport_image(const EquirectFilm& film, const Viewport& viewport, int width, int height,
                        UnsampledPixels unsampled, const Workers& workers) {
  RgbImage view(width, height);
  const Resampler resampler(film, viewport, view, unsampled);
  workers.for_each_block(static_cast<std::size_t>(height), row_block,
                         [&](std::size_t begin, std::size_t end) {
                           resampler.resample(static_cast<int>(begin), static_cast<int>(end));
                         });
  return view;
}

RgbImage viewport_image(const RgbImage& panorama, const Viewport& viewport, int width, int height) {
  RgbImage view(width, height);
  // No pixel of the view is larger than the one on the lens' axis but under a strange lens.
  const double largest_sr =
      viewport.sr_per_area(viewport.lens().axis) / (static_cast<double>(width) * height);
  const PanoramaPyramid pyramid(panorama,
                                2 + static_cast<int>(level_for(largest_sr, panorama.height)));
  Resampler(pyramid, viewport, view, UnsampledPixels::black).resample(0, height);
  return view;
}

}  // namespace foveola
