// The published study's mean times, to compare a study's own with.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/descriptive.h"

namespace foveola::analysis {

/// A method's mean time in per cent of the omnidirectional preview's; the paper gives a range.
struct PublishedMean {
  std::string method;
  Interval percent_of_od;
};

/// Reads data/koskela2018/mean_percent_of_od.csv. Throws Error if it is missing or malformed.
std::vector<PublishedMean> read_published_means(const std::filesystem::path& path);

/// The published range for `method` measured against `baseline`; empty where there is none, as for
/// any baseline but "od".
std::optional<Interval> published_mean_of(const std::vector<PublishedMean>& means,
                                          const std::string& baseline, const std::string& method);

}  // namespace foveola::analysis
