// The exact interval of a proportion.
#pragma once

#include <cstddef>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// Clopper and Pearson's (1934) exact interval for `successes` of `trials`; trials >= 1.
Interval clopper_pearson(std::size_t successes, std::size_t trials,
                         double confidence = default_confidence);

}  // namespace foveola::analysis
