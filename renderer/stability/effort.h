// How hard the stress tests try, and who may stop them.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>

#include "renderer/base/parallel.h"

namespace foveola {

/// The sizes of all stress tests. The defaults are for a minute or two on two cores.
struct StabilityEffort {
  /// Relative tolerance of radiance with a known answer, which is sampled until five of its
  /// standard errors are below this.
  double tolerance = 0.01;
  std::uint64_t most_samples = 1 << 22;  ///< most samples for one such radiance
  int picture_width = 64;  ///< width of compared pictures, twice their height; multiple of 32
  int picture_samples_per_pixel = 64;        ///< in pictures that are compared with each other
  std::uint64_t leak_paths = 1'000'000;      ///< in each of the closed rooms
  std::uint64_t scene_paths = 1'000'000;     ///< over all given scenes
  std::uint32_t scene_seed = 1;              ///< seed of these paths
  std::uint64_t film_samples = 100'000'000;  ///< into one pixel
};

constexpr StabilityEffort quick_effort{};
/// For the figures of a release: about an hour on two cores.
constexpr StabilityEffort thorough_effort{.tolerance = 0.001,
                                          .most_samples = std::uint64_t{1} << 28,
                                          .picture_samples_per_pixel = 1024,
                                          .leak_paths = 10'000'000,
                                          .scene_paths = 10'000'000,
                                          .film_samples = 1'000'000'000};
/// Hours.
constexpr StabilityEffort full_effort{.tolerance = 0.001,
                                      .most_samples = std::uint64_t{1} << 30,
                                      .picture_samples_per_pixel = 16384,
                                      .leak_paths = 100'000'000,
                                      .scene_paths = 1'000'000'000,
                                      .film_samples = 1'000'000'000};

/// What every stress test is given. `workers` must outlive it.
struct StabilityRun {
  const Workers& workers;
  StabilityEffort effort;
  std::stop_token stop;  ///< a test that is stopped returns early, and its figures are of no use
  std::function<void(double)> progress = [](double) {};  ///< gets the fraction done of this test
};

}  // namespace foveola
