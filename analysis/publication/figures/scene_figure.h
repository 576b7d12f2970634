// Draws the figure of the times of all marks in each scene.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/publication/figures/figures.h"

namespace foveola::analysis {

/// Returns the figure's marks: those for which a participant has a method's time and the baseline's
/// in a scene.
std::vector<std::size_t> marks_in_scenes(const StudyTables& tables);

/// Returns whether a right-censored time of these marks is left out.
bool lacks_censored_times(const StudyTables& tables);

/// relative_times_by_scene: per cent of the baseline, on a logarithmic axis. It shows geometric
/// means over participants with 95 % confidence intervals, in each scene and over all, and the
/// number of participants. Points that leave out a right-censored time are hollow. Empty without
/// values.
std::optional<Figure> relative_scene_figure(const StudyTables& tables);

}  // namespace foveola::analysis
