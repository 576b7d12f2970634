// All stress tests of numerical stability, one after the other, with one progress line.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "renderer/base/scene_source.h"
#include "renderer/stability/effort.h"
#include "renderer/stability/figure.h"

namespace foveola {

/// The figures of every test that ended before `stop` was requested. progress gets the fraction
/// done and what is being tested. The scenes are those whose radiance must be finite; their camera
/// positions must be known.
std::vector<StabilityFigure> measure_stability(
    const StabilityEffort& effort, const std::vector<SceneSource>& scenes, const Workers& workers,
    const std::function<void(double, const std::string&)>& progress, const std::stop_token& stop);

}  // namespace foveola
