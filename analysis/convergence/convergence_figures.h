// Draws errors over samples and over seconds as SVG, by gnuplot.
#pragma once

#include <vector>

#include "analysis/convergence/convergence_tables.h"
#include "analysis/gnuplot/gnuplot.h"

namespace foveola::analysis {

/// Draws, for each measurement, RMSE within 5 degrees, in the viewport and over the sphere, and
/// FLIP in the viewport, each over samples and over seconds; logarithmic, with slopes. Figures
/// without points are left out. Names are `error-N-...`, N the measurement's number from 1. Throws
/// Error if gnuplot is missing.
std::vector<Figure> draw_convergence(const std::vector<GazeMeasurement>& measurements);

}  // namespace foveola::analysis
