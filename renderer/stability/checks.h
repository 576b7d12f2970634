// The stress tests of numerical stability, each a function from its size to its figures.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/stability/effort.h"
#include "renderer/stability/figure.h"

namespace foveola {

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
/// up to 10^5 times by glTF's nodes: the same picture; and surfaces that do not shadow themselves.
std::vector<StabilityFigure> check_scale_and_place(const StabilityRun& run);

/// Closed rooms with a bright world outside: paths that see anything of it, per room.
std::vector<StabilityFigure> check_leaks(const StabilityRun& run);

/// Triangles, normals and materials that no careful exporter writes.
std::vector<StabilityFigure> check_degenerate_input(const StabilityRun& run);

/// Very many samples in one pixel against their exact mean.
std::vector<StabilityFigure> check_accumulation(const StabilityRun& run);

/// The same picture to the bit on 1, 2 and 4 threads, in batches of several sizes, and stopped and
/// continued.
std::vector<StabilityFigure> check_bit_equality(const StabilityRun& run);

/// Paths over `scenes` with every view sampler whose radiance is not finite, or negative.
std::vector<StabilityFigure> check_finite_radiance(const StabilityRun& run,
                                                   const std::vector<SceneSource>& scenes);

}  // namespace foveola
