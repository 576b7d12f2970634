// The gaze of a recorded session, to be looked at or replayed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "renderer/gaze/eye_tracker.h"

namespace foveola::study {

/// The samples of the participant's last attempt at a trial, 0 being the first, in the order of
/// their arrival; times are of the session's clock. Throws Error if the file is no study, there are
/// none, or they are not what was written.
std::vector<GazeSample> read_gaze(const std::filesystem::path& path, const std::string& participant,
                                  std::size_t trial);

}  // namespace foveola::study
