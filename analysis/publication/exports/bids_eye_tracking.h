// Writes recorded gaze in the Brain Imaging Data Structure (BIDS 1.11.1, from BEP 20).
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/publication/exports/data_files.h"
#include "study/record/read/data_quality_records.h"
#include "study/record/read/recorded_gaze.h"

namespace foveola::analysis {

/// Exports attempts one after the other, in the order of the session, and numbers a participant's
/// recordings as BIDS runs. Gaze is recorded only while a trial is timed, and a BIDS file has one
/// constant sampling frequency.
class EyeTrackingExport {
 public:
  /// Exports the participants of `set`. A participant's accuracy is that of the last of
  /// `validations` with a valid sample. `gaze` names the tracker of each attempt.
  EyeTrackingExport(const Dataset& set, const std::vector<study::GazeRunRow>& validations,
                    const std::vector<study::AttemptGazeRow>& gaze);

  /// Counts the recording as the subject's next run.
  /// Returns bids/sub-LABEL/beh/sub-LABEL_task-preview_run-RUN_recording-eye1 with _physio.tsv.gz,
  /// _physio.json, _physioevents.tsv.gz and _physioevents.json. A sample has the session clock's
  /// time in nanoseconds, then azimuth (rightwards) and elevation (upwards) in degrees from
  /// straight ahead, in the head's axes; "n/a" without gaze. Events are the first frame, the marks
  /// and the eye's movements; without events the last two files are omitted. A mouse in place of
  /// the eye is a recording-mouse of the generic PhysioType, without eye and movements. Empty for a
  /// participant who is not analysed, or with too few samples for a frequency.
  std::vector<TextFile> export_attempt(const study::AttemptGaze& attempt);

  /// Returns bids/.bidsignore if any file so far needs it: it hides files from validators older
  /// than BIDS 1.11, and says so itself.
  std::optional<TextFile> bidsignore_file() const;

  /// Number of the analysed participants' recordings with too few samples.
  std::size_t too_short() const { return too_short_; }

 private:
  struct Subject {
    std::string label;
    int runs = 0;
    std::optional<double> accuracy_deg;
  };
  std::map<std::string, Subject> subjects_;  ///< By the participant's code.
  /// By the participant's code, trial and attempt.
  std::map<std::tuple<std::string, std::size_t, int>, std::string> trackers_;
  std::size_t too_short_ = 0;
  bool has_events_ = false;
};

}  // namespace foveola::analysis
