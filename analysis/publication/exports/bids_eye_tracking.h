// Recorded gaze as the Brain Imaging Data Structure (BIDS 1.11.1, from BEP 20) lays it out.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "analysis/dataset/dataset.h"
#include "analysis/publication/exports/data_files.h"
#include "study/record/data_quality_records.h"
#include "study/record/recorded_gaze.h"

namespace foveola::analysis {

/// Takes attempts one after the other, in the order of the session, and numbers a participant's
/// recordings as BIDS's runs: gaze is only recorded while a trial is timed, and a BIDS file has one
/// constant sampling frequency.
class EyeTrackingExport {
 public:
  /// Exports the participants of `set`. A participant's accuracy is that of the last of
  /// `validations` with any valid sample; `gaze` names the tracker of each attempt.
  EyeTrackingExport(const Dataset& set, const std::vector<study::GazeRunRow>& validations,
                    const std::vector<study::AttemptGazeRow>& gaze);

  /// bids/sub-LABEL/beh/sub-LABEL_task-preview_run-RUN_recording-eye1 with _physio.tsv.gz,
  /// _physio.json, _physioevents.tsv.gz and _physioevents.json. A sample is its time by the
  /// session's clock in nanoseconds, then azimuth (rightwards) and elevation (upwards) in degrees
  /// from straight ahead, in the head's axes; "n/a" where the tracker saw no gaze. Events are the
  /// first frame, the marks and the eye's movements; without any, the last two files are left out.
  /// Where a mouse stood for the eye, it is a recording-mouse of the generic PhysioType, without
  /// eye and movements. Empty for a participant who is not analysed, or if the samples are too few
  /// to have a frequency.
  std::vector<TextFile> files_of(const study::AttemptGaze& attempt);

  /// bids/.bidsignore if any file so far needs it, so that validators that know no BIDS 1.11 pass
  /// over what they would refuse; it says so itself.
  std::optional<TextFile> ignored() const;

  /// The number of the analysed participants' recordings that had too few samples.
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
