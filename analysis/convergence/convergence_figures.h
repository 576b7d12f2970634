// Errors over samples and over seconds, as SVG drawn by gnuplot.
#pragma once

#include <vector>

#include "analysis/convergence/convergence_tables.h"
#include "analysis/gnuplot/gnuplot.h"

namespace foveola::analysis {

/// For each measurement RMSE within 5 degrees, in the viewport and over the sphere, and FLIP in the
/// viewport, each over samples and beside that over seconds; logarithmic, with slopes. Only what
/// has points. Names are `error-N-...`, N the measurement's number from 1. Throws Error if
/// gnuplot is missing.
std::vector<Figure> draw_convergence(const std::vector<GazeMeasurement>& measurements);

}  // namespace foveola::analysis
