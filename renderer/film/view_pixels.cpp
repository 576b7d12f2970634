#include "renderer/film/view_pixels.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <numbers>

#include "renderer/view/equirect.h"

namespace foveola {
namespace {

constexpr int mantissa_bits = 52;
constexpr std::uint64_t bias = 1023;
constexpr std::uint64_t bits_of_one = bias << mantissa_bits;

/// The integer as a double: doubles from 2^52 are a unit apart, and their bits count them.
double double_of(std::uint64_t small) {
  constexpr std::uint64_t bits_of_2_to_52 = (bias + mantissa_bits) << mantissa_bits;
  constexpr double two_to_52 = 4503599627370496.0;
  return std::bit_cast<double>(bits_of_2_to_52 | small) - two_to_52;
}

/// log2 within 1e-14, without branches or calls, so that compilers vectorise it: the exponent, plus
/// for a mantissa m in [sqrt(1/2), sqrt(2)) the series ln m = 2 (s + s^3/3 + s^5/5 + ...) with s =
/// (m - 1) / (m + 1).
double near_log2(double number) {
  constexpr std::uint64_t bits_of_root_of_half = 0x3FE6A09E667F3BCD;
  const auto bits = std::bit_cast<std::uint64_t>(number);
  const std::uint64_t biased_exponent =
      (bits - bits_of_root_of_half + bits_of_one) >> mantissa_bits;
  const double exponent = double_of(biased_exponent) - static_cast<double>(bias);
  const auto m = std::bit_cast<double>(bits - (biased_exponent << mantissa_bits) + bits_of_one);
  const double s = (m - 1.0) / (m + 1.0);
  const double z = s * s;
  const double series =
      1.0 +
      z * (1.0 / 3 +
           z * (1.0 / 5 +
                z * (1.0 / 7 +
                     z * (1.0 / 9 +
                          z * (1.0 / 11 + z * (1.0 / 13 + z * (1.0 / 15 + z * (1.0 / 17))))))));
  return exponent + 2.0 * std::numbers::log2e * s * series;
}

/// Width of a patch of `sr` steradians, in cells of level 0.
double cells_across(double sr, int image_height) {
  const double cell_rad = std::numbers::pi / image_height;
  return std::sqrt(sr) / cell_rad;
}

std::size_t whole_lanes(int width, int height) {
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return (count + lane_count - 1) / lane_count * lane_count;
}

Floats load_eight(const float* numbers) {
  Floats lanes;
  __builtin_memcpy(&lanes, numbers, sizeof(lanes));
  return lanes;
}

Floats pick(const std::vector<float>& numbers, const EightPixels& at) {
  return Floats{numbers[at[0]], numbers[at[1]], numbers[at[2]], numbers[at[3]],
                numbers[at[4]], numbers[at[5]], numbers[at[6]], numbers[at[7]]};
}

constexpr int tile_side = EquirectFilm::tile_size;

/// Columns or rows. Of those within a tile's side of the tile at `begin`, these cover all tiles:
/// the image's last tile may be narrower than others.
std::array<int, 5> ends_around(int begin) {
  return {begin - tile_side, begin - 1, begin, begin + tile_side, begin + 2 * tile_side - 1};
}

/// A mark per tile of a film.
class TileMarks {
 public:
  explicit TileMarks(const EquirectFilm& film)
      : film_(film), marks_(static_cast<std::size_t>(film.tiles_across()) * film.tiles_down()) {}

  void mark_around(std::uint32_t tile) {
    const IVec2 corner = film_.tile_corner(tile);
    const int last_row = film_.height() - 1;
    for (const int y : ends_around(corner.y)) {
      if (y < 0) {
        mark_rows(0, std::min(-1 - y, last_row));
      } else if (y > last_row) {
        mark_rows(std::max(2 * last_row + 1 - y, 0), last_row);
      } else {
        mark_columns_around(corner.x, y);
      }
    }
  }

  std::vector<std::uint32_t> numbers() const {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t tile = 0; tile < marks_.size(); ++tile) {
      if (marks_[tile] != 0) {
        numbers.push_back(tile);
      }
    }
    return numbers;
  }

 private:
  /// All tiles with pixels in the rows [first, last].
  void mark_rows(int first, int last) {
    std::fill(marks_.begin() + film_.tile_of(0, first),
              marks_.begin() + film_.tile_of(film_.width() - 1, last) + 1, char{1});
  }
  void mark_columns_around(int begin, int y) {
    for (const int x : ends_around(begin)) {
      // Images narrower than a tile wrap more than once.
      const int wrapped = (x % film_.width() + film_.width()) % film_.width();
      marks_[film_.tile_of(wrapped, y)] = 1;
    }
  }

  const EquirectFilm& film_;
  std::vector<char> marks_;
};

}  // namespace

void rounded_log2(std::span<const double> numbers, std::span<float> logs) {
  assert(numbers.size() == logs.size());
  // If all numbers this near round to one float, so does the library's.
  constexpr double margin = 1e-12;
  constexpr std::size_t block = 64;
  for (std::size_t begin = 0; begin < numbers.size(); begin += block) {
    const std::size_t end = std::min(begin + block, numbers.size());
    int doubtful = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const double log = near_log2(numbers[i]);
      logs[i] = static_cast<float>(log - margin);
      doubtful += logs[i] == static_cast<float>(log + margin) ? 0 : 1;
    }
    for (std::size_t i = begin; doubtful > 0 && i < end; ++i) {
      logs[i] = static_cast<float>(std::log2(numbers[i]));
    }
  }
}

float level_for(double sr, int image_height) {
  return static_cast<float>(std::max(0.0, std::log2(cells_across(sr, image_height))));
}

ViewPixels::ViewPixels(int width, int height)
    : width_(width),
      height_(height),
      u_(whole_lanes(width, height)),
      v_(whole_lanes(width, height)),
      level_(whole_lanes(width, height)) {}

void ViewPixels::place(const Viewport& viewport, int begin, int end) {
  // A copy that no store below can alias, so that compilers vectorise over eight pixels.
  const Viewport view = viewport;
  for (int y = begin; y < end; ++y) {
    float* const u = &u_[row(y)];
    float* const v = &v_[row(y)];
    for (int x = 0; x < width_; ++x) {
      const Vec2 image = equirect_from_direction(view.direction(middle_of(x, y)));
      u[x] = image.x;
      v[x] = image.y;
    }
  }
  if (end == height_) {
    std::fill(u_.begin() + count(), u_.end(), u_[count() - 1]);
    std::fill(v_.begin() + count(), v_.end(), v_[count() - 1]);
  }
}

void ViewPixels::choose_levels(const Viewport& viewport, int image_height, int last_level,
                               int begin, int end) {
  const Vec2 half_size = viewport.half_size();
  const RadialLens lens = viewport.lens();
  const double pixels = count();
  std::vector<double> widths(static_cast<std::size_t>(width_));
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < width_; ++x) {
      widths[x] =
          cells_across(sr_per_area(half_size, lens, middle_of(x, y)) / pixels, image_height);
    }
    const std::span<float> levels(&level_[row(y)], widths.size());
    rounded_log2(widths, levels);
    for (float& level : levels) {
      level = std::clamp(level, 0.0F, static_cast<float>(last_level));
    }
  }
}

float ViewPixels::highest_level() const {
  Floats highest{};
  for (std::size_t first = 0; first < level_.size(); first += lane_count) {
    highest = larger(highest, load_eight(&level_[first]));
  }
  FloatLanes lanes;
  lanes.store(highest);
  return *std::ranges::max_element(lanes);
}

ViewPoints ViewPixels::points(const EightPixels& pixels) const {
  return {.image = {pick(u_, pixels), pick(v_, pixels)}, .level = pick(level_, pixels)};
}

ViewPoints ViewPixels::points_from(std::size_t first) const {
  return {.image = {load_eight(&u_[first]), load_eight(&v_[first])},
          .level = load_eight(&level_[first])};
}

TilesInView::TilesInView(const EquirectFilm& film)
    : film_(&film),
      size_(Vec2(film.width(), film.height()) / static_cast<float>(tile_side)),
      last_(film.tiles_across() - 1, film.tiles_down() - 1),
      is_marked_(static_cast<std::size_t>(film.tiles_across()) * film.tiles_down()) {}

void TilesInView::forget() {
  for (std::atomic<bool>& mark : is_marked_) {
    mark.store(false, std::memory_order_relaxed);
  }
}

void TilesInView::mark(const Vec2s& image) {
  const Ints column = truncated(smaller(image.x * size_.x, last_.x));
  const Ints row = truncated(smaller(image.y * size_.y, last_.y));
  const Ints tiles = row * film_->tiles_across() + column;
  std::int32_t marked = -1;
  for (std::size_t i = 0; i < lane_count; ++i) {
    // Neighbours are mostly in the same tile.
    if (tiles[i] != marked) {
      marked = tiles[i];
      is_marked_[static_cast<std::size_t>(marked)].store(true, std::memory_order_relaxed);
    }
  }
}

std::vector<std::uint32_t> TilesInView::around() const {
  TileMarks marks(*film_);
  for (std::uint32_t tile = 0; tile < is_marked_.size(); ++tile) {
    if (is_marked_[tile].load(std::memory_order_relaxed)) {
      marks.mark_around(tile);
    }
  }
  return marks.numbers();
}

}  // namespace foveola
