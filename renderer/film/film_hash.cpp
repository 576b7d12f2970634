#include "renderer/film/film_hash.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/base/digest.h"

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
