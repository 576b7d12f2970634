#include "analysis/publication/gaze_checks.h"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"

namespace foveola::analysis {
namespace {

constexpr double most_elsewhere_percent = 50.0;  ///< Foveola's own, for want of a published one.

DataQualityCheck check_validation(const Dataset& set, const std::vector<study::GazeRunRow>& runs) {
  std::map<std::string, study::GazeRunRow> last_runs;
  for (const study::GazeRunRow& run : runs) {
    last_runs[run.participant] = run;
  }
  std::size_t passed = 0;
  std::size_t validated = 0;
  std::optional<double> largest_deg;
  for (const std::string& participant : set.participants) {
    const auto run = last_runs.find(participant);
    if (run != last_runs.end()) {
      ++validated;
      passed += run->second.passed ? 1 : 0;
      largest_deg = std::max(largest_deg, run->second.accuracy_deg);
    }
  }
  DataQualityCheck check{"Validation of the gaze", "none recorded", "the protocol's gate"};
  if (validated > 0) {
    check.found =
        fmt::format("{} of {} passed{}", passed, counted(set.participants.size(), "participant"),
                    largest_deg ? fmt::format("; accuracy {:.2f}° at most", *largest_deg) : "");
    check.verdict = within(passed == set.participants.size());
  }
  return check;
}

/// An analysed test trial whose gaze is known.
struct TrackedTrial {
  std::string name;  ///< Participant, scene and method.
  const study::AttemptGazeRow* gaze = nullptr;
};

std::vector<TrackedTrial> tracked_trials(const Dataset& set, const study::StudyRecords& records,
                                         const GazeOfTrials& gaze) {
  std::vector<TrackedTrial> tracked;
  for (const std::size_t i : analysed_trials(records, set)) {
    const study::TrialRow& trial = records.trials[i];
    if (const study::AttemptGazeRow* const row = gaze.of(i)) {
      tracked.push_back({fmt::format("{}, {}, {}", row->participant, records.scenes[trial.scene],
                                     records.methods[trial.method]),
                         row});
    }
  }
  return tracked;
}

DataQualityCheck check_objects_in_view(const std::vector<TrackedTrial>& trials) {
  DataQualityCheck check{"Marks with the object out of view",
                         "the object or the field of view was not recorded", "none, ours"};
  std::size_t marks = 0;
  std::vector<Finding> out_of_view;
  for (const TrackedTrial& trial : trials) {
    for (const study::GazeAtMark& mark : trial.gaze->figures.marks) {
      marks += mark.object_in_view ? 1 : 0;
      if (mark.object_in_view && !*mark.object_in_view) {
        out_of_view.push_back(
            {trial.gaze->participant, fmt::format("{}, {}", trial.name, mark.mark)});
      }
    }
  }
  if (marks > 0) {
    check.found = fmt::format("{} of {}{}", out_of_view.size(), counted(marks, "mark"),
                              colon_and_findings(out_of_view));
    check.verdict = within(out_of_view.empty());
  }
  return check;
}

DataQualityCheck check_gaze_elsewhere(const std::vector<TrackedTrial>& trials) {
  DataQualityCheck check{
      "Trials with the gaze elsewhere", "the gaze or the object was not recorded",
      fmt::format("{:g} % of each trial’s time to its last mark with a valid gaze that is not on "
                  "the object, ours",
                  most_elsewhere_percent)};
  std::size_t known = 0;
  std::vector<Finding> elsewhere;
  for (const TrackedTrial& trial : trials) {
    if (const auto percent = percents_of(trial.gaze->figures.times).elsewhere) {
      ++known;
      if (*percent > most_elsewhere_percent) {
        elsewhere.push_back(
            {trial.gaze->participant, fmt::format("{}: {:.0f} %", trial.name, *percent)});
      }
    }
  }
  if (known > 0) {
    check.found = fmt::format("{} of {}{}", elsewhere.size(), counted(known, "trial"),
                              colon_and_findings(elsewhere));
    check.verdict = within(elsewhere.empty());
  }
  return check;
}

}  // namespace

std::vector<DataQualityCheck> check_gaze(const Dataset& set, const study::StudyRecords& records,
                                         const std::vector<study::GazeRunRow>& runs,
                                         const GazeOfTrials& gaze) {
  const std::vector<TrackedTrial> tracked = tracked_trials(set, records, gaze);
  return {check_validation(set, runs), check_objects_in_view(tracked),
          check_gaze_elsewhere(tracked)};
}

}  // namespace foveola::analysis
