// The labels that a rating's points had in sessions by an amended protocol.
#pragma once

#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"

namespace foveola::analysis {

/// Of each rating of `records`, the labels that differ from the study's in sessions of
/// `participants`. Throws Error with its place for a text that is no protocol.
std::vector<AmendedLabels> amended_labels(const study::StudyRecords& records,
                                          const std::vector<std::string>& participants);

/// The scale in words, with the labels that amended sessions had: "1 (none) to 5 (all over). In 2
/// analysed sessions, by an amended protocol, the points were …".
std::string scale_with_amendments(const Dataset& set, std::size_t measure);

/// The sentence on other labels alone, with a space before it; usually empty.
std::string amendments_of_scale(const Dataset& set, std::size_t measure);

}  // namespace foveola::analysis
