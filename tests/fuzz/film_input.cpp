#include "tests/fuzz/film_input.h"

#include <cstdint>
#include <fstream>
#include <limits>
#include <vector>

#include "renderer/base/error.h"
#include "renderer/base/files/digest.h"
#include "renderer/film/film_file.h"
#include "tests/fuzz/input_bytes.h"

namespace foveola::test {
namespace {

std::vector<PixelState> pixels_of(const std::filesystem::path& file) {
  FilmFileReader reader(file);
  return rest_of(reader);
}

bool is_same(const PixelState& a, const PixelState& b) {
  return a.pixel == b.pixel && a.count == b.count && a.numbered == b.numbered && a.sum == b.sum &&
         a.squares == b.squares;
}

/// Twice a number is exact.
void merge_with_itself(const PixelState& pixel, PixelSum& sum) {
  if (pixel.numbered > std::numeric_limits<std::uint32_t>::max() / 2) {
    return;
  }
  sum.add(pixel);
  sum.add(pixel);
  const PixelState twice{.pixel = pixel.pixel,
                         .count = 2 * pixel.count,
                         .numbered = 2 * pixel.numbered,
                         .sum = 2.0 * pixel.sum,
                         .squares = 2.0 * pixel.squares};
  check_that(is_same(sum.take(), twice), "a pixel and itself are not twice the pixel");
}

void make_film(const FilmHeader& header, const std::vector<PixelState>& pixels) {
  static const Workers workers(1);
  EquirectFilm film(header.size.x, header.size.y, header.statistics);
  film.restore(pixels, workers);
  const std::vector<PixelState> back = state_of(film);
  check_that(back.size() == pixels.size(), "the film has other pixels");
  for (std::size_t i = 0; i < back.size(); ++i) {
    check_that(is_same(back[i], pixels[i]), "the film has another pixel");
  }
}

}  // namespace

bool read_film_input(const std::filesystem::path& folder, std::string_view input) {
  constexpr std::int64_t small_film = 1 << 16;  // pixels
  const std::filesystem::path file = folder / "a.film";
  std::ofstream(file, std::ios::binary) << input << sha256(input);
  try {
    const FilmHeader header = FilmFileReader(file).header();
    const std::vector<PixelState> pixels = pixels_of(file);
    PixelSum sum;
    for (const PixelState& pixel : pixels) {
      merge_with_itself(pixel, sum);
    }
    if (std::int64_t{header.size.x} * header.size.y <= small_film) {
      make_film(header, pixels);
    }
    return true;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace foveola::test
