// What a film holds, apart from it, bit for bit: to go on with it elsewhere, and to put together
// the parts of one.
#pragma once

#include <cstdint>
#include <span>
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

}  // namespace foveola
