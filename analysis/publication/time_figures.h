// The figures of the times of all marks.
#pragma once

#include <optional>

#include "analysis/publication/figures.h"

namespace foveola::analysis {

/// relative_times: in per cent of the baseline. Empty without values.
std::optional<Figure> relative_figure(const StudyTables& tables);

/// times_in_seconds. Empty without values.
std::optional<Figure> seconds_figure(const StudyTables& tables);

}  // namespace foveola::analysis
