// How many of the paper's means a study meets.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/koskela2018/published_comparison.h"

namespace foveola::analysis {

/// A study's mean is near a published one if neither is more than this many times the other.
inline constexpr double near_factor = 1.5;

/// How many of a part of the paper's means this study meets.
struct MetMeans {
  std::string means;  ///< Which: "Table 1", "Table 2, OD", "Table 2, VP and FV, own ratios", ...
  std::size_t published = 0;
  std::size_t compared = 0;  ///< Those of which the study has its own.
  std::size_t study_in_published_interval = 0;
  std::size_t published_in_study_interval = 0;
  std::size_t in_both_intervals = 0;
  std::optional<std::size_t> near;  ///< Within near_factor; not counted in Table 1.
};

/// Of Table 1; of Table 2's OD; of its VP and FV in each reading.
std::vector<MetMeans> count_met_means(const std::vector<ComparedNumber>& numbers);

/// A sentence, as "Table 2, VP and FV, own ratios: of 20 published means, ...".
std::string in_words(const MetMeans& met);

}  // namespace foveola::analysis
