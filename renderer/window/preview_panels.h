// The live preview's panels: text over the picture.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "renderer/gaze/gaze_correction.h"
#include "renderer/gaze/gaze_quality.h"
#include "renderer/gaze/profiles.h"
#include "renderer/preview/live_frames.h"

namespace foveola {

/// Summary of the last second's frames.
std::vector<std::string> frame_time_lines(std::span<const LiveFrame> frames,
                                          const std::string& method);

/// How well the tracker saw the eye look at targets.
std::string gaze_quality_line(const GazeQuality& quality);

/// The correction as formulas of the azimuth a and the elevation e, in degrees.
std::string gaze_correction_line(const GazeCorrection& correction);

/// Latency from the eye's movement to the light of the last second's frames, stage by stage;
/// assumed stages are marked.
std::vector<std::string> latency_lines(std::span<const LiveFrame> frames,
                                       const TrackerProfile& tracker,
                                       const DisplayProfile& display);

}  // namespace foveola
