// What a validation of gaze found, as JSON that gives it back exactly.
#pragma once

#include <nlohmann/json.hpp>

#include "study/session/session.h"

namespace foveola::study {

nlohmann::ordered_json json_of(const GazeRun& run);

/// Throws what nlohmann::json throws if it is not what json_of makes.
GazeRun gaze_run_from(const nlohmann::ordered_json& json);

/// {"azimuth": [a, b, c], "elevation": [d, e, f]}, as schema.sql describes at gaze_run.
nlohmann::ordered_json json_of(const GazeCorrection& correction);
GazeCorrection gaze_correction_from(const nlohmann::ordered_json& json);

}  // namespace foveola::study
