#include "analysis/publication/data_quality/session_checks.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "renderer/base/text/utf8.h"

namespace foveola::analysis {
namespace {

constexpr double max_elsewhere_percent = 50.0;  ///< Foveola's own: there is no published one.

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
    check.value_text = fmt::format(
        "{} of {} passed{}", passed, count_with_noun(set.participants.size(), "participant"),
        largest_deg ? fmt::format("; accuracy {:.2f}° at most", *largest_deg) : "");
    check.verdict = verdict_of(passed == set.participants.size());
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
    if (const study::AttemptGazeRow* const row = gaze[i]) {
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
    check.value_text = fmt::format("{} of {}{}", out_of_view.size(), count_with_noun(marks, "mark"),
                                   findings_suffix(out_of_view));
    check.verdict = verdict_of(out_of_view.empty());
  }
  return check;
}

DataQualityCheck check_gaze_elsewhere(const std::vector<TrackedTrial>& trials) {
  DataQualityCheck check{
      "Trials with the gaze elsewhere", "the gaze or the object was not recorded",
      fmt::format("{:g} % of each trial’s time to its last mark with a valid gaze that is not on "
                  "the object, ours",
                  max_elsewhere_percent)};
  std::size_t known = 0;
  std::vector<Finding> elsewhere;
  for (const TrackedTrial& trial : trials) {
    if (const auto percent = percents_of(trial.gaze->figures.times).elsewhere) {
      ++known;
      if (*percent > max_elsewhere_percent) {
        elsewhere.push_back(
            {trial.gaze->participant, fmt::format("{}: {:.0f} %", trial.name, *percent)});
      }
    }
  }
  if (known > 0) {
    check.value_text = fmt::format("{} of {}{}", elsewhere.size(), count_with_noun(known, "trial"),
                                   findings_suffix(elsewhere));
    check.verdict = verdict_of(elsewhere.empty());
  }
  return check;
}

// These limits are Foveola's own, as there are no published ones. Only the latency's is published:
// people begin to notice foveation at 50 to 70 ms (Albert, Patney, Luebke, Kim 2017).
constexpr double most_late_percent = 1.0;
constexpr double max_untracked_percent = 10.0;
constexpr double longest_latency_ms = 50.0;
constexpr double longest_mark_gap_ms = 100.0;

double percent_of_frames(const study::FrameFigures& row, std::uint64_t some) {
  return 100.0 * static_cast<double>(some) / static_cast<double>(row.frames);
}

/// The participant with the maximum, and all participants above the limit.
struct Worst {
  double value = 0.0;
  std::string participant;
  std::vector<std::string> above;
};

template <typename Value>
Worst worst_of(const std::vector<study::FrameFigures>& frames, double limit, const Value& value) {
  Worst worst;
  for (const study::FrameFigures& row : frames) {
    if (value(row) > limit) {
      worst.above.push_back(row.participant);
    }
    if (worst.participant.empty() || value(row) > worst.value) {
      worst.value = value(row);
      worst.participant = row.participant;
    }
  }
  return worst;
}

template <typename Value>
DataQualityCheck check_figure(const std::vector<study::FrameFigures>& frames, std::string name,
                              const char* unit, double limit, const std::string& whose,
                              const Value& value) {
  DataQualityCheck check{std::move(name), "", fmt::format("{:g} {}, {}", limit, unit, whose)};
  if (frames.empty()) {
    check.value_text = "no frames recorded";
    return check;
  }
  const Worst worst = worst_of(frames, limit, value);
  check.value_text =
      fmt::format("at most {:.3g} {}, participant {}; above the limit: {}", worst.value, unit,
                  worst.participant, worst.above.empty() ? "none" : comma_list(worst.above));
  check.verdict = verdict_of(worst.above.empty());
  return check;
}

std::string all_in_words(const std::vector<std::string>& findings) {
  return findings.empty() ? "none" : fmt::format("{}", fmt::join(findings, "; "));
}

DataQualityCheck check_cut_off(const std::vector<study::SessionCourse>& courses) {
  DataQualityCheck check{"Interrupted sessions", "no sessions recorded", "none, ours"};
  if (courses.empty()) {
    return check;
  }
  std::vector<std::string> cut_off;
  for (const study::SessionCourse& course : courses) {
    if (course.interruptions > 0) {
      cut_off.push_back(fmt::format("{}: {}, {} lost", course.participant,
                                    count_with_noun(course.interruptions, "time"),
                                    count_with_noun(course.attempts_lost, "attempt")));
    }
  }
  check.value_text = all_in_words(cut_off);
  check.verdict = verdict_of(cut_off.empty());
  return check;
}

DataQualityCheck check_notes(const std::vector<study::SessionCourse>& courses) {
  constexpr std::size_t max_characters = 80;
  DataQualityCheck check{"Notes in the sessions’ records", "no sessions recorded",
                         "none but those of routine, ours"};
  if (courses.empty()) {
    return check;
  }
  std::vector<std::string> noted;
  for (const study::SessionCourse& course : courses) {
    if (!course.notes.empty()) {
      const std::size_t others = course.notes.size() - 1;
      noted.push_back(fmt::format("{}: {}{}", course.participant,
                                  beginning_of(course.notes.front(), max_characters),
                                  others == 0 ? "" : fmt::format(" (and {} more)", others)));
    }
  }
  check.value_text = all_in_words(noted);
  check.verdict = verdict_of(noted.empty());
  return check;
}

/// Outcomes of a trial's non-final timings, except interrupted ones.
using EarlierOutcomes = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::string>>;

/// By session and trial.
EarlierOutcomes earlier_outcomes(const study::StudyRecords& records) {
  EarlierOutcomes outcomes;
  for (const study::TrialRow& row : records.trials) {
    const std::string& outcome = records.words[row.outcome];
    if (!row.counts && outcome != "interrupted") {
      outcomes[{row.session, row.trial}].push_back(outcome);
    }
  }
  return outcomes;
}

DataQualityCheck check_timed_again(const Dataset& set, const study::StudyRecords& records) {
  const EarlierOutcomes earlier = earlier_outcomes(records);
  const std::vector<std::size_t> trials = analysed_trials(records, set);
  std::vector<Finding> again;
  for (const std::size_t i : trials) {
    const study::TrialRow& row = records.trials[i];
    if (const auto found = earlier.find({row.session, row.trial}); found != earlier.end()) {
      const std::string& participant = records.participant_of(row);
      again.push_back(
          {participant, fmt::format("{}, {}, {} ({})", participant, records.scenes[row.scene],
                                    records.methods[row.method], comma_list(found->second))});
    }
  }
  return {"Retimed trials",
          fmt::format("{} of {}{}", again.size(), count_with_noun(trials.size(), "trial"),
                      findings_suffix(again)),
          "none but after an interruption, ours", verdict_of(again.empty())};
}

/// Times depend on the renderer.
DataQualityCheck check_programs(const Dataset& set,
                                const std::vector<study::SessionPrograms>& sessions) {
  DataQualityCheck check{"Programs that ran the sessions", "no programs recorded",
                         "one, of one version and built with the same tools, ours"};
  const std::vector<study::SessionPrograms> analysed = of_analysed(set, sessions);
  const std::vector<study::ProgramUse> uses = study::program_uses(analysed);
  if (uses.empty()) {
    return check;
  }
  std::vector<std::string> words;
  std::ranges::transform(uses, std::back_inserter(words), study::use_in_words);
  for (const study::SessionPrograms& session : analysed) {
    if (session.programs.size() > 1) {
      words.push_back(
          fmt::format("{} by {}", session.participant, study::programs_in_words(session.programs)));
    }
  }
  check.value_text = fmt::format("{}", fmt::join(words, "; "));
  check.verdict = verdict_of(uses.size() == 1);
  return check;
}

DataQualityCheck check_setups(const std::vector<study::SessionSetup>& sessions) {
  const std::vector<std::string> varying = study::varying_setup(sessions);
  return {"Displays, machines and trackers",
          varying.empty() ? "the same for everybody, as far as recorded" : all_in_words(varying),
          "the same for everybody, ours", verdict_of(varying.empty())};
}

}  // namespace

std::vector<DataQualityCheck> check_sessions(const Dataset& set, const study::StudyRecords& records,
                                             const study::DataQualityRecords& quality) {
  const std::vector<study::SessionCourse> analysed = of_analysed(set, quality.courses);
  return {check_cut_off(analysed), check_timed_again(set, records), check_notes(analysed),
          check_programs(set, records.programs), check_setups(of_analysed(set, quality.setups))};
}

std::vector<DataQualityCheck> check_frames(const std::vector<study::FrameFigures>& frames) {
  return {check_figure(frames, "Frames that missed their refresh", "%", most_late_percent, "ours",
                       [](const auto& row) { return percent_of_frames(row, row.late); }),
          check_figure(frames, "Frames without a valid gaze", "%", max_untracked_percent, "ours",
                       [](const auto& row) { return percent_of_frames(row, row.untracked); }),
          check_figure(
              frames, "Latency, from the eye to the display", "ms", longest_latency_ms,
              "of 50 to 70 that Albert et al. 2017 tolerate",
              [](const auto& row) { return 1e3 * (row.mean_gaze_age_s + row.mean_to_display_s); }),
          check_figure(frames, "From a frame to the mark upon it, the longest", "ms",
                       longest_mark_gap_ms, "ours",
                       [](const auto& row) { return 1e3 * row.longest_mark_after_frame_s; })};
}

std::vector<DataQualityCheck> check_gaze(const Dataset& set, const study::StudyRecords& records,
                                         const std::vector<study::GazeRunRow>& runs,
                                         const GazeOfTrials& gaze) {
  const std::vector<TrackedTrial> tracked = tracked_trials(set, records, gaze);
  return {check_validation(set, runs), check_objects_in_view(tracked),
          check_gaze_elsewhere(tracked)};
}

}  // namespace foveola::analysis
