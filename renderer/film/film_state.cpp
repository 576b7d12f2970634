#include "renderer/film/film_state.h"

#include <limits>

#include "renderer/base/error.h"

namespace foveola {

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

}  // namespace foveola
