#include "renderer/film/film_state.h"

#include <array>
#include <bit>
#include <cstddef>
#include <limits>

#include "renderer/base/digest.h"
#include "renderer/base/error.h"

namespace foveola {
namespace {

/// A pixel as it is hashed: its bytes in memory are those that the header promises.
struct HashedPixel {
  std::uint32_t number;
  std::uint32_t count;
  DVec3 sum;
};
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(HashedPixel) == 32);

/// Pixels that are hashed together.
constexpr std::size_t pixels_at_once = 4096;

}  // namespace

std::vector<PixelState> state_of(const EquirectFilm& film) {
  std::vector<PixelState> states;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      if (const std::optional<PixelState> state = film.pixel_state(x, y)) {
        states.push_back(*state);
      }
    }
  }
  return states;
}

void PixelSum::add(const PixelState& state) {
  pixel_ = state.pixel;
  count_ += state.count;
  numbered_ += state.numbered;
  red_.add(state.sum.r);
  green_.add(state.sum.g);
  blue_.add(state.sum.b);
  squares_.add(state.squares);
}

PixelState PixelSum::take() {
  if (numbered_ > std::numeric_limits<std::uint32_t>::max()) {
    throw Error("films", "have more samples in a pixel than one image can hold", "merge fewer");
  }
  const PixelState state{.pixel = pixel_,
                         .count = static_cast<std::uint32_t>(count_),
                         .numbered = static_cast<std::uint32_t>(numbered_),
                         .sum = {red_.rounded(), green_.rounded(), blue_.rounded()},
                         .squares = squares_.rounded()};
  count_ = 0;
  numbered_ = 0;
  for (ExactSum* const sum : {&red_, &green_, &blue_, &squares_}) {
    sum->clear();  // and keeps its memory for the next of millions of pixels
  }
  return state;
}

std::string film_sha256(const EquirectFilm& film) {
  Sha256 digest;
  const std::array<std::uint32_t, 2> size = {static_cast<std::uint32_t>(film.width()),
                                             static_cast<std::uint32_t>(film.height())};
  digest.update(std::as_bytes(std::span(size)));
  std::vector<HashedPixel> pixels;
  pixels.reserve(pixels_at_once);
  const auto hash_pixels = [&] {
    digest.update(std::as_bytes(std::span(pixels)));
    pixels.clear();
  };
  film.for_each_sampled_pixel([&](const IVec2& place, const FilmTile::Pixel& pixel) {
    pixels.push_back({.number = static_cast<std::uint32_t>(place.y) * size[0] +
                                static_cast<std::uint32_t>(place.x),
                      .count = pixel.count,
                      .sum = pixel.sum});
    if (pixels.size() == pixels_at_once) {
      hash_pixels();
    }
  });
  hash_pixels();
  return digest.hex();
}

}  // namespace foveola
