// The stress tests of numerical stability, as functions from their size to their figures.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/base/work/parallel.h"

namespace foveola {

struct StabilityFigure {
  std::string name;
  double measured = 0.0;  ///< NaN if it could not be measured, which is a failure
  double bound = 0.0;     ///< maximum accepted value
  std::string unit;       ///< unit of both values: "%", "standard errors", "of 1000000 paths"
  std::string details;    ///< the method, and the place of the worst case

  bool passes() const { return measured <= bound; }
};

/// The sizes of all stress tests. The defaults are for a minute or two on two cores.
struct StabilityEffort {
  /// Relative tolerance of radiance with a known answer. Sampling continues until five of its
  /// standard errors are below this.
  double tolerance = 0.01;
  std::uint64_t max_samples = 1 << 22;  ///< maximum number of samples for one such radiance
  int picture_width = 64;  ///< width of compared pictures, twice their height; multiple of 32
  int picture_samples_per_pixel = 64;        ///< in pictures to compare
  std::uint64_t leak_paths = 1'000'000;      ///< in each of the closed rooms
  std::uint64_t scene_paths = 1'000'000;     ///< over all given scenes
  std::uint32_t scene_seed = 1;              ///< seed of these paths
  std::uint64_t film_samples = 100'000'000;  ///< into one pixel
};

constexpr StabilityEffort quick_effort{};
/// For the figures of a release: about an hour on two cores.
constexpr StabilityEffort thorough_effort{.tolerance = 0.001,
                                          .max_samples = std::uint64_t{1} << 28,
                                          .picture_samples_per_pixel = 1024,
                                          .leak_paths = 10'000'000,
                                          .scene_paths = 10'000'000,
                                          .film_samples = 1'000'000'000};
/// Hours.
constexpr StabilityEffort full_effort{.tolerance = 0.001,
                                      .max_samples = std::uint64_t{1} << 30,
                                      .picture_samples_per_pixel = 16384,
                                      .leak_paths = 100'000'000,
                                      .scene_paths = 1'000'000'000,
                                      .film_samples = 1'000'000'000};

/// The input of every stress test. `workers` must outlive it.
struct StabilityRun {
  const Workers& workers;
  StabilityEffort effort;
  std::stop_token stop;  ///< a stopped test returns early, with meaningless figures
  std::function<void(double)> progress = [](double) {};  ///< receives this test's done fraction
};

/// Radiance 1 everywhere: lossless materials must show 1, and no material more. In a constant
/// environment (open) and in a closed sphere that emits and reflects one half (closed); all
/// varieties of Material, roughness 0.001 to 1, angles to grazing.
std::vector<StabilityFigure> check_white_furnaces(const StabilityRun& run);
/// White furnaces of materials with any mixture of layers.
std::vector<StabilityFigure> check_mixed_layers(const StabilityRun& run);

/// Emitting and reflecting enclosure, sphere and rectangle lights, point, spot and directional
/// lights, and a slab of absorbing glass against their closed forms.
std::vector<StabilityFigure> check_known_answers(const StabilityRun& run);

/// A closed room, scaled by 10^-3 to 10^6 and moved up to 10^3 times its size by its vertices and
/// up to 10^5 times by glTF's nodes: equal pictures; and no self-shadowing.
std::vector<StabilityFigure> check_scale_and_place(const StabilityRun& run);

/// Closed rooms in a bright world: number of paths per room that see the outside.
std::vector<StabilityFigure> check_leaks(const StabilityRun& run);

/// Triangles, normals and materials that careful exporters never write.
std::vector<StabilityFigure> check_degenerate_input(const StabilityRun& run);

/// Very many samples in one pixel against their exact mean.
std::vector<StabilityFigure> check_accumulation(const StabilityRun& run);

/// The same picture to the bit on 1, 2 and 4 threads, in batches of several sizes, and stopped and
/// continued.
std::vector<StabilityFigure> check_bit_equality(const StabilityRun& run);

/// Paths over `scenes` with every view sampler whose radiance is not finite, or negative.
std::vector<StabilityFigure> check_finite_radiance(const StabilityRun& run,
                                                   const std::vector<SceneSource>& scenes);

struct StabilityCheck {
  std::string name;
  double weight = 1.0;  ///< its share of the time, roughly
  std::function<std::vector<StabilityFigure>(const StabilityRun&)> run;
};

/// All checks of this header, in order. scenes: for check_finite_radiance; their camera positions
/// must be known.
std::vector<StabilityCheck> stability_checks(const std::vector<SceneSource>& scenes);

/// The figures of every check that ended before `stop` was requested. progress: receives the done
/// fraction and the check's name.
std::vector<StabilityFigure> measure_stability(
    const std::vector<StabilityCheck>& checks, const StabilityEffort& effort,
    const Workers& workers, const std::function<void(double, const std::string&)>& progress,
    const std::stop_token& stop);

}  // namespace foveola
