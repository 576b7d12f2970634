// What data quality follows from in a study's sessions: frames, gaze and objects, validations,
// reactions, interruptions and notes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/record/read/attempt_gaze_figures.h"
#include "study/record/setup/session_setup.h"

namespace foveola::study {

/// Figures of all frames that a session presented in the counted attempts at its test trials.
struct FrameFigures {
  std::string participant;
  std::uint64_t frames = 0;
  std::uint64_t late = 0;          ///< missed their refresh
  std::uint64_t untracked = 0;     ///< without has_gaze
  double mean_gaze_age_s = 0.0;    ///< how old the gaze was that a frame used, in the mean
  double mean_to_display_s = 0.0;  ///< from polling to the display
  double longest_frame_s = 0.0;    ///< from one presented frame to the next
  std::uint64_t marks = 0;
  double mean_mark_after_frame_s = 0.0;  ///< from the frame that was seen to the mark
  double longest_mark_after_frame_s = 0.0;
};

/// Where gaze and object were in an attempt that has frames, at whatever kind of trial.
struct AttemptGazeRow {
  std::string participant;
  std::size_t trial = 0;  ///< in the session's plan, from 0
  int attempt = 1;
  /// The name of the eye tracker's profile, "simulated" of a simulated participant; empty if the
  /// record does not say.
  std::string tracker;
  AttemptGazeFigures figures;
};

/// One look at a validation's targets; angles in degrees, empty where nothing was seen.
struct GazeRunRow {
  std::string participant;
  int run = 0;
  std::optional<double> accuracy_deg;
  std::optional<double> precision_rms_deg;
  double data_loss = 0.0;  ///< 0 to 1
  bool passed = false;     ///< whether it passed the protocol's gate
};

/// A key pressed at something that appeared.
struct ReactionRow {
  std::string participant;
  double seconds = 0.0;  ///< below zero if it was a false start
  bool early = false;
};

/// What happened to a session beside what its trials measured.
struct SessionCourse {
  std::string participant;
  std::size_t interruptions = 0;   ///< how often it was cut off, or left before its end
  std::size_t attempts_lost = 0;   ///< attempts that these ended
  std::vector<std::string> notes;  ///< in the order of time, without is_routine_note
};

struct DataQualityRecords {
  std::vector<FrameFigures> frames;  ///< a row for each session that has frames
  std::vector<AttemptGazeRow> gaze;  ///< by session, trial and attempt
  std::vector<GazeRunRow> gaze_runs;
  std::vector<ReactionRow> reactions;
  std::vector<SessionCourse> courses;  ///< a row for each session
  std::vector<SessionSetup> setups;    ///< likewise, of withdrawn ones too
};

/// Reads a study's file without changing it, attempt by attempt; none of withdrawn sessions. Throws
/// Error as read_study does, or if frames are not what was written.
DataQualityRecords read_data_quality(const std::filesystem::path& path);

}  // namespace foveola::study
