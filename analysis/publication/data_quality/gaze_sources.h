// What stood for participants' eyes: an eye tracker, a simulated eye, or the mouse pointer.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/publication/data_quality/data_quality_checks.h"
#include "study/record/data_quality_records.h"

namespace foveola::analysis {

/// Whether this tracker's gaze is the mouse pointer's.
bool is_mouse(const std::string& tracker);

/// "the mouse pointer in place of an eye", "the eye tracker of profile fove0" and so on.
std::string tracker_in_words(const std::string& tracker);

/// A tracker, and the analysed participants whose gaze came from it.
struct GazeSource {
  std::string tracker;
  std::vector<std::string> participants;
};

/// Each tracker that the record names; a participant who went on with another has both.
std::vector<GazeSource> gaze_sources(const Dataset& set,
                                     std::span<const study::AttemptGazeRow> gaze);

/// "the mouse pointer in place of an eye (P1, P2); the eye tracker of profile fove0 (P3)", without
/// participants where all have the same; empty if the record names none.
std::string gaze_sources_in_words(const std::vector<GazeSource>& sources);

/// Flags a mouse in place of an eye, and sessions that differ.
DataQualityCheck check_gaze_source(const Dataset& set, std::span<const study::AttemptGazeRow> gaze);

}  // namespace foveola::analysis
