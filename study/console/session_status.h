// Status of a session for the experimenter: its phase, its next steps, its frames, gaze and
// warnings.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "renderer/base/clock.h"

namespace foveola::study {

struct FrameStatus {
  std::optional<double> rate_hz;  ///< over the last second; empty in the first
  double refresh_rate_hz = 0.0;   ///< the display's
  std::uint64_t frames = 0;       ///< of the current attempt at a trial, or the last one
  std::uint64_t late = 0;         ///< frames of them that missed their refresh
};

struct GazeStatus {
  std::string eye;  ///< tracked, pointer, simulated or recorded
  std::optional<double>
      valid;  ///< fraction of the last second's samples, in [0, 1]; empty: no samples
  std::optional<double> age_s;  ///< of the newest valid sample; empty: there is none
};

enum class WarningKind {
  no_focus,
  no_key,
  awaits_gaze,
  no_gaze,
  late_frames,
  slow_drawing,
  slow_record
};

/// Returns the name for machines: "late_frames".
const char* name_of(WarningKind kind);

struct StatusWarning {
  WarningKind kind = WarningKind::no_gaze;
  std::string text;  ///< whole sentences
};

struct SessionStatus {
  std::string participant;
  Nanoseconds time{0};  ///< session clock
  bool is_paused = false;
  std::string now;       ///< "marking, trial 3 of 15: arcade with fv"
  std::string then;      ///< "trial 4 of 15: arcade with od"
  std::string next_key;  ///< the participant's: "Space marks outline"
  FrameStatus frames;
  GazeStatus gaze;
  std::string last_mark;  ///< "outline was marked after 3.214 s."; empty before the first
  std::vector<StatusWarning> warnings;  ///< present warnings
};

/// Returns "59.8 a second of 60; 2 of 812 late in this trial".
std::string words_for(const FrameStatus& frames);
/// Returns "tracked; 97 % valid, the newest 12 ms old", or, in capitals, the substitute for an eye.
std::string words_for(const GazeStatus& gaze);

/// Warns if more frames of the attempt are late than the analysis accepts without a flag.
std::optional<StatusWarning> warning_of(const FrameStatus& frames);

/// Warns if the session has waited for the participant's key for minutes.
std::optional<StatusWarning> warning_of(Nanoseconds since_last_key);

/// Returns warnings of kinds that `before` does not have.
std::vector<StatusWarning> new_warnings(const std::vector<StatusWarning>& before,
                                        const std::vector<StatusWarning>& now);

nlohmann::ordered_json json_of(const SessionStatus& status);

}  // namespace foveola::study
