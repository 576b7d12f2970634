// What a film holds, apart from it, bit for bit: to continue it elsewhere, and as one short text.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "renderer/base/exact_sum.h"
#include "renderer/film/equirect_film.h"

namespace foveola {

/// Every pixel of `film` that samples were numbered in, in the order of their numbers.
std::vector<PixelState> state_of(const EquirectFilm& film);

/// Puts the same pixel of several films together: what falls in none is in none of them. Sums are
/// rounded once, from their exact values, so that neither their order nor how they are grouped
/// matters as long as each film is given by itself.
class PixelSum {
 public:
  /// All of one pixel.
  void add(const PixelState& state);
  /// The sum, and begins anew. Throws Error for more samples than a pixel can have.
  PixelState take();

 private:
  std::uint32_t pixel_ = 0;
  std::uint64_t count_ = 0;
  std::uint64_t numbered_ = 0;
  ExactSum red_;
  ExactSum green_;
  ExactSum blue_;
  ExactSum squares_;
};

/// The SHA-256, as 64 lower-case hexadecimal digits, of what fell on the film since it was cleared.
///
/// The bytes are the film's width and height, 4 bytes each, and then 32 bytes for each pixel with
/// samples, in the order of their numbers: the number, y * width + x, and the count of its samples,
/// 4 bytes each, and the sums of their red, green and blue, 8 bytes each. Integers are without
/// sign, sums are IEEE 754's double precision, all of them little-endian.
///
/// Neither the number of threads nor how samples were cut into batches changes it, nor whether the
/// film keeps variances.
std::string film_sha256(const EquirectFilm& film);

}  // namespace foveola
