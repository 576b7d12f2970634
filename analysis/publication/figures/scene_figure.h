// The figure of the times of all marks in each scene.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/publication/figures/figures.h"

namespace foveola::analysis {

/// The marks that the figure has: somebody has a method's time and the baseline's in a scene.
std::vector<std::size_t> marks_in_scenes(const StudyTables& tables);

/// Whether a right-censored time of these marks is left out.
bool lacks_censored_times(const StudyTables& tables);

/// relative_times_by_scene: per cent of the baseline on a logarithmic axis, the geometric means
/// over participants in each scene with their 95 % intervals, and those of all scenes; hollow where
/// a right-censored time is left out, the number of participants beside each. Empty without values.
std::optional<Figure> relative_scene_figure(const StudyTables& tables);

}  // namespace foveola::analysis
