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

struct StabilityCheck {
  std::string name;
  double weight = 1.0;  ///< its share of the time, roughly
  std::function<std::vector<StabilityFigure>(const StabilityRun&)> run;
};

/// All of checks.h, in its order. The scenes are those whose radiance must be finite; their camera
/// positions must be known.
std::vector<StabilityCheck> stability_checks(const std::vector<SceneSource>& scenes);

/// The figures of every check that ended before `stop` was requested. progress gets the fraction
/// done and the name of the check.
std::vector<StabilityFigure> measure_stability(
    const std::vector<StabilityCheck>& checks, const StabilityEffort& effort,
    const Workers& workers, const std::function<void(double, const std::string&)>& progress,
    const std::stop_token& stop);

}  // namespace foveola
