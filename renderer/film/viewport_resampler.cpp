#include "renderer/film/viewport_resampler.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <numeric>

namespace foveola {
namespace {

/// A complete image as a pyramid.
SpherePlanes<PremultipliedTexel> pyramid_over(const RgbImage& panorama, int levels) {
  SpherePlanes<PremultipliedTexel> cells(panorama.width, panorama.height, levels);
  for (int y = 0; y < panorama.height; ++y) {
    for (int x = 0; x < panorama.width; ++x) {
      cells.set(0, x, y, {panorama.at(x, y), 1.0F});
    }
  }
  for (int level = 1; level < levels; ++level) {
    const auto below = [&](int x, int y) { return *cells.at(level - 1, x, y); };
    for (int y = 0; y < cells.height(level); ++y) {
      for (int x = 0; x < cells.width(level); ++x) {
        cells.set(level, x, y,
                  mean_of_square(x, y, cells.width(level - 1), cells.height(level - 1), below));
      }
    }
  }
  return cells;
}

/// Rows of the view, or pixels, per task: whole groups of eight.
constexpr std::size_t rows_in_task = 16;
constexpr std::size_t pixels_in_task = 4096;
static_assert(rows_in_task % lane_count == 0 && pixels_in_task % lane_count == 0);

std::optional<float> linear_exposure(const std::optional<double>& stops) {
  return stops ? std::optional(exposure_scale(*stops)) : std::nullopt;
}

void put(const EightPixels& pixels, const Vec3s& colors, RgbImage& image) {
  Vec3Lanes shown;
  shown.store(colors);
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    if (pixels[lane] < image.pixels.size()) {
      image.pixels[pixels[lane]] = shown.at(lane);
    }
  }
}

/// colors: in [0, 1].
void put(const EightPixels& pixels, const Vec3s& colors, ByteImage& image) {
  const auto byte = [](const Floats& channel) { return truncated(255.0F * channel + 0.5F); };
  constexpr std::int32_t opaque = std::int32_t{-1} << 24U;
  const Ints shown =
      byte(colors.x) | byte(colors.y) << 8 | byte(colors.z) << 16 | (Ints{} + opaque);
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    if (pixels[lane] < image.pixels.size()) {
      image.pixels[pixels[lane]] = static_cast<std::uint32_t>(shown[lane]);
    }
  }
}

EightPixels eight_from(std::size_t first) {
  EightPixels pixels;
  std::iota(pixels.begin(), pixels.end(), static_cast<std::uint32_t>(first));
  return pixels;
}

}  // namespace

RgbImage viewport_image(const EquirectFilm& film, const Viewport& viewport, int width, int height,
                        UnsampledPixels unsampled, const Workers& workers) {
  ViewportResampler resampler(film, {.width = width, .height = height, .unsampled = unsampled});
  return resampler.show(viewport, workers);
}

RgbImage viewport_image(const RgbImage& panorama, const Viewport& viewport, int width, int height) {
  const auto longest_side = static_cast<unsigned>(std::max(panorama.width, panorama.height));
  const int single_cell_level = std::bit_width(longest_side - 1);
  ViewPixels pixels(width, height);
  pixels.place(viewport, 0, height);
  pixels.choose_levels(viewport, panorama.height, single_cell_level, 0, height);
  const int highest = static_cast<int>(std::ceil(pixels.highest_level()));
  const SpherePlanes<PremultipliedTexel> cells = pyramid_over(panorama, highest + 1);
  RgbImage view(width, height);
  for (std::size_t first = 0; first < view.pixels.size(); first += lane_count) {
    const ViewPoints points = pixels.points_from(first);
    Vec3s color;
    shown_colors(cells, std::span(&points, 1), UnsampledPixels::black, std::span(&color, 1));
    Vec3Lanes shown;
    shown.store(color);
    for (std::size_t pixel = first; pixel < std::min(first + lane_count, view.pixels.size());
         ++pixel) {
      view.pixels[pixel] = shown.at(pixel - first);
    }
  }
  return view;
}

template <typename Image>
FilmResampler<Image>::FilmResampler(const EquirectFilm& film, const ViewImage& settings)
    : film_(&film),
      copy_(film),
      pixels_(settings.width, settings.height),
      tiles_in_view_(film),
      image_(settings.width, settings.height) {
  change_look(settings);
}

template <typename Image>
void FilmResampler<Image>::change_look(const ViewImage& settings) {
  assert(settings.width == image_.width && settings.height == image_.height);
  unsampled_ = settings.unsampled;
  exposure_ = linear_exposure(settings.exposure_stops);
  curve_ = settings.curve;
  has_new_look_ = true;
  if (viewport_) {
    note_levels();
  }
}

template <typename Image>
const Image& FilmResampler<Image>::show(const Viewport& viewport, const Workers& workers) {
  const bool has_moved = viewport_ != viewport;
  if (!has_moved && !has_new_look_ && film_->revision() == shown_at_) {
    return image_;
  }
  if (has_moved) {
    aim(viewport, workers);
  }
  copy_.refresh(tiles_, workers);
  if (reads_above_tiles_) {
    copy_.refresh_above_tiles();
  }
  const bool all = has_moved || has_new_look_ || film_->cleared_at() > shown_at_ || !knows_changes_;
  if (!all && squares_.empty()) {
    find_squares(workers);
  }
  workers.for_each_block(pixels_.count(), pixels_in_task, [&](std::size_t begin, std::size_t end) {
    if (all) {
      paint_all(begin, end);
    } else {
      paint_changed(begin, end);
    }
  });
  shown_at_ = film_->revision();
  has_new_look_ = false;
  return image_;
}

template <typename Image>
void FilmResampler<Image>::aim(const Viewport& viewport, const Workers& workers) {
  const bool same_lens = has_same_lens(viewport);
  const int last_level = film_->levels() - 1;
  tiles_in_view_.forget();
  const auto rows = static_cast<std::size_t>(image_.height);
  workers.for_each_block(rows, rows_in_task, [&](std::size_t begin_row, std::size_t end_row) {
    const auto begin = static_cast<int>(begin_row);
    const auto end = static_cast<int>(end_row);
    if (!same_lens) {
      pixels_.choose_levels(viewport, film_->height(), last_level, begin, end);
    }
    pixels_.place(viewport, begin, end);
    const auto width = static_cast<std::size_t>(image_.width);
    for (std::size_t first = begin_row * width; first < end_row * width; first += lane_count) {
      tiles_in_view_.mark(pixels_.points_from(first).image);
    }
  });
  tiles_ = tiles_in_view_.around();
  squares_.clear();
  viewport_ = viewport;
  if (!same_lens) {
    note_levels();
  }
}

template <typename Image>
bool FilmResampler<Image>::has_same_lens(const Viewport& viewport) const {
  return viewport_ && viewport_->half_size() == viewport.half_size() &&
         viewport_->lens() == viewport.lens();
}

template <typename Image>
void FilmResampler<Image>::note_levels() {
  const auto highest = static_cast<int>(std::ceil(pixels_.highest_level()));
  const bool fills = unsampled_ == UnsampledPixels::filled;
  reads_above_tiles_ = fills || highest >= FilmTile::levels;
  const int cell = 1 << std::max(highest, 1);  // SquareChanges begin at level 1
  knows_changes_ =
      !reads_above_tiles_ && film_->width() % (2 * cell) == 0 && film_->height() % cell == 0;
}

template <typename Image>
void FilmResampler<Image>::find_squares(const Workers& workers) {
  squares_.resize(pixels_.count());
  workers.for_each_block(pixels_.count(), pixels_in_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t first = begin; first < end; first += lane_count) {
      const std::array<std::uint32_t, lane_count> eight =
          copy_.changes().squares(pixels_.points_from(first));
      std::copy_n(eight.begin(), std::min(lane_count, end - first), squares_.begin() + first);
    }
  });
}

template <typename Image>
void FilmResampler<Image>::paint_all(std::size_t begin, std::size_t end) {
  std::array<EightPixels, max_view_points> pixels;
  std::array<ViewPoints, max_view_points> points;
  while (begin < end) {
    std::size_t count = 0;
    for (; count < max_view_points && begin < end; begin += lane_count) {
      pixels[count] = eight_from(begin);
      points[count++] = pixels_.points_from(begin);
    }
    paint(std::span(pixels).first(count), std::span(points).first(count));
  }
}

template <typename Image>
void FilmResampler<Image>::paint_changed(std::size_t begin, std::size_t end) {
  std::array<std::uint32_t, pixels_in_task + lane_count> changed;
  std::size_t count = 0;
  for (std::size_t pixel = begin; pixel < end; ++pixel) {
    changed[count] = static_cast<std::uint32_t>(pixel);
    count += copy_.changes().changed_at(squares_[pixel]) > shown_at_ ? 1 : 0;
  }
  // Completes the last group with valid pixels.
  std::fill_n(changed.begin() + count, lane_count, static_cast<std::uint32_t>(begin));
  std::array<EightPixels, max_view_points> pixels;
  std::array<ViewPoints, max_view_points> points;
  for (std::size_t first = 0; first < count;) {
    std::size_t groups = 0;
    for (; groups < max_view_points && first < count; first += lane_count) {
      std::copy_n(changed.begin() + first, lane_count, pixels[groups].begin());
      points[groups] = pixels_.points(pixels[groups]);
      ++groups;
    }
    paint(std::span(pixels).first(groups), std::span(points).first(groups));
  }
}

template <typename Image>
void FilmResampler<Image>::paint(std::span<const EightPixels> pixels,
                                 std::span<const ViewPoints> points) {
  std::array<Vec3s, max_view_points> colors;
  shown_colors(copy_.cells(), points, unsampled_, std::span(colors).first(points.size()));
  for (std::size_t group = 0; group < pixels.size(); ++group) {
    Vec3s color = colors[group];
    if (exposure_) {
      color = all_lanes(*exposure_) * color;
      color = {display_from_linear(color.x, curve_), display_from_linear(color.y, curve_),
               display_from_linear(color.z, curve_)};
    }
    put(pixels[group], color, image_);
  }
}

template class FilmResampler<RgbImage>;
template class FilmResampler<ByteImage>;

}  // namespace foveola
