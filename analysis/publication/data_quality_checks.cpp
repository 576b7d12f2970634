#include "analysis/publication/data_quality_checks.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/statistics/order_balance.h"

namespace foveola::analysis {
namespace {

// These limits are Foveola's own, for want of published ones, except that of the latency: at 50 to
// 70 ms people begin to notice foveation (Albert, Patney, Luebke, Kim 2017).
constexpr double most_late_percent = 1.0;
constexpr double most_untracked_percent = 10.0;
constexpr double longest_latency_ms = 50.0;
constexpr double longest_mark_gap_ms = 100.0;
constexpr double least_balance_p = 0.01;
constexpr double most_false_alarms_percent = 20.0;
constexpr double most_elsewhere_percent = 50.0;

Verdict within(bool good) { return good ? Verdict::passed : Verdict::flagged; }

/// The figures of the participants who are analysed.
std::vector<study::FrameFigures> analysed_frames(const StudyTables& tables,
                                                 const study::DataQualityRecords& quality) {
  const std::set<std::string> analysed(tables.set.participants.begin(),
                                       tables.set.participants.end());
  std::vector<study::FrameFigures> frames;
  std::copy_if(quality.frames.begin(), quality.frames.end(), std::back_inserter(frames),
               [&](const study::FrameFigures& row) { return analysed.contains(row.participant); });
  return frames;
}

double percent_of_frames(const study::FrameFigures& row, std::uint64_t some) {
  return 100.0 * static_cast<double>(some) / static_cast<double>(row.frames);
}

/// The participant with the largest value, and how many lie above the limit.
struct Worst {
  double value = 0.0;
  std::string participant;
  std::size_t above = 0;
};

template <typename Value>
Worst worst_of(const std::vector<study::FrameFigures>& frames, double limit, const Value& value) {
  Worst worst;
  for (const study::FrameFigures& row : frames) {
    worst.above += value(row) > limit ? 1 : 0;
    if (worst.participant.empty() || value(row) > worst.value) {
      worst.value = value(row);
      worst.participant = row.participant;
    }
  }
  return worst;
}

/// A check of each participant's own figure against a limit.
template <typename Value>
DataQualityCheck check_frames(const std::vector<study::FrameFigures>& frames, std::string name,
                              const char* unit, double limit, const std::string& whose,
                              const Value& value) {
  DataQualityCheck check{std::move(name), "", fmt::format("{:g} {}, {}", limit, unit, whose)};
  if (frames.empty()) {
    check.found = "no frames recorded";
    return check;
  }
  const Worst worst = worst_of(frames, limit, value);
  check.found = fmt::format("at most {:.3g} {}, participant {}; {} above the limit", worst.value,
                            unit, worst.participant, worst.above);
  check.verdict = within(worst.above == 0);
  return check;
}

DataQualityCheck check_validation(const StudyTables& tables,
                                  const study::DataQualityRecords& quality) {
  std::map<std::string, study::GazeRunRow> last_runs;
  for (const study::GazeRunRow& run : quality.gaze_runs) {
    last_runs[run.participant] = run;
  }
  std::size_t passed = 0;
  std::size_t validated = 0;
  std::optional<double> largest_deg;
  for (const std::string& participant : tables.set.participants) {
    const auto run = last_runs.find(participant);
    if (run != last_runs.end()) {
      ++validated;
      passed += run->second.passed ? 1 : 0;
      largest_deg = std::max(largest_deg, run->second.accuracy_deg);
    }
  }
  DataQualityCheck check{"Validation of the gaze", "none recorded", "the protocol's gate"};
  if (validated > 0) {
    check.found = fmt::format(
        "{} of {} passed{}", passed, counted(tables.set.participants.size(), "participant"),
        largest_deg ? fmt::format("; accuracy {:.2f}° at most", *largest_deg) : "");
    check.verdict = within(passed == tables.set.participants.size());
  }
  return check;
}

/// The positions of the methods in one scene of one participant; empty unless each position is
/// taken once: a trial that is missing from the record has no position of its own.
std::vector<std::size_t> positions_of_methods(std::span<const Trial> block) {
  std::vector<std::size_t> positions;
  for (const Trial& trial : block) {
    positions.push_back(static_cast<std::size_t>(trial.method_position));
  }
  std::vector<std::size_t> sorted = positions;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t position = 0; position < sorted.size(); ++position) {
    if (sorted[position] != position) {
      return {};
    }
  }
  return positions;
}

/// How often each method had each position, over the participants' scenes with all their trials.
PositionCounts count_positions(const Dataset& set) {
  const std::size_t methods = set.methods.size();
  PositionCounts counts(methods, std::vector<std::size_t>(methods, 0));
  const std::span<const Trial> trials(set.trials);
  for (std::size_t first = 0; first < trials.size(); first += methods) {
    const std::vector<std::size_t> positions = positions_of_methods(trials.subspan(first, methods));
    for (std::size_t method = 0; method < positions.size(); ++method) {
      ++counts[method][positions[method]];
    }
  }
  return counts;
}

DataQualityCheck check_order(const Dataset& set) {
  DataQualityCheck check{"Balance of the methods’ order", "one method",
                         fmt::format("no worse than chance at {:g}, ours", least_balance_p)};
  if (set.methods.size() < 2) {
    return check;
  }
  const std::optional<OrderBalance> balance = order_balance(count_positions(set));
  if (!balance) {
    check.found = "no participant has all trials of a scene";
    return check;
  }
  check.found = fmt::format("each method {} to {} times in each place; P {}", balance->fewest,
                            balance->most, p_value(balance->p));
  check.verdict = within(balance->p >= least_balance_p);
  return check;
}

DataQualityCheck check_kind(const StudyTables& tables) {
  const std::string warning = data_warning(tables);
  return {"People’s data", warning.empty() ? "only people’s sessions in the file" : warning,
          "no simulated and no pilot sessions", within(warning.empty())};
}

/// All times of the participant's trials, of every mark.
std::vector<double> measured_times(const Dataset& set, std::size_t participant) {
  std::vector<double> times;
  for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
    for (std::size_t method = 0; method < set.methods.size(); ++method) {
      for (const std::size_t mark : set.times()) {
        if (const Value& time = set.value(participant, scene, method, mark); time.is_measured()) {
          times.push_back(time.number);
        }
      }
    }
  }
  return times;
}

/// The catch trials of the analysed participants: of each, its last timing.
std::vector<CatchFigures> catch_figures(const Dataset& set, const study::StudyRecords& records) {
  std::map<std::string, CatchFigures> figures;
  for (std::size_t i = 0; i < records.trials.size(); ++i) {
    const study::TrialRow& row = records.trials[i];
    if (row.kind != study::TrialKind::catch_trial || !row.counts || row.attempt == 0) {
      continue;
    }
    CatchFigures& own = figures[records.participant_of(row)];
    ++own.trials;
    bool has_mark = false;
    for (const std::size_t mark : set.times()) {
      has_mark = has_mark || records.value(i, mark).is_measured();
    }
    own.false_alarms += has_mark ? 1 : 0;
  }
  std::vector<CatchFigures> rows;
  for (const std::string& participant : set.participants) {
    if (const auto own = figures.find(participant); own != figures.end()) {
      rows.push_back(own->second);
      rows.back().participant = participant;
    }
  }
  return rows;
}

DataQualityCheck check_catches(const std::vector<CatchFigures>& catches) {
  DataQualityCheck check{
      "False alarms in catch trials", "no catch trials recorded",
      fmt::format("{:g} % of each participant's, ours", most_false_alarms_percent)};
  if (catches.empty()) {
    return check;
  }
  std::size_t trials = 0;
  std::size_t false_alarms = 0;
  std::vector<std::string> above;
  for (const CatchFigures& row : catches) {
    trials += row.trials;
    false_alarms += row.false_alarms;
    if (row.false_alarms_percent() > most_false_alarms_percent) {
      above.push_back(row.participant);
    }
  }
  check.found = fmt::format("a mark in {} of {}{}", false_alarms, counted(trials, "catch trial"),
                            above.empty() ? "" : "; above the limit: " + listed(above));
  check.verdict = within(above.empty());
  return check;
}

/// The first of them, and that there are others.
std::string first_of(const std::vector<std::string>& all) {
  constexpr std::size_t most_named = 3;
  const std::span<const std::string> named = std::span(all).first(std::min(most_named, all.size()));
  return fmt::format("{}{}", fmt::join(named, "; "),
                     all.size() > named.size() ? "; and others" : "");
}

DataQualityCheck check_outliers(const std::vector<OutlyingTime>& outliers) {
  std::vector<std::string> names;
  for (const OutlyingTime& time : outliers) {
    names.push_back(fmt::format("{}, {}, {}, {}: {:.2g} × the expected", time.participant,
                                time.scene, time.method, time.mark, time.times_expected));
  }
  return {"Single times that stand out",
          names.empty() ? "none" : fmt::format("{}: {}", names.size(), first_of(names)),
          "none; by chance, one study in twenty has any (Rosner’s test, level 5 %, for each mark)",
          within(outliers.empty())};
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
  std::vector<std::string> out_of_view;
  for (const TrackedTrial& trial : trials) {
    for (const study::GazeAtMark& mark : trial.gaze->figures.marks) {
      marks += mark.object_in_view ? 1 : 0;
      if (mark.object_in_view && !*mark.object_in_view) {
        out_of_view.push_back(fmt::format("{}, {}", trial.name, mark.mark));
      }
    }
  }
  if (marks > 0) {
    check.found = fmt::format("{} of {}{}{}", out_of_view.size(), counted(marks, "mark"),
                              out_of_view.empty() ? "" : ": ", first_of(out_of_view));
    check.verdict = within(out_of_view.empty());
  }
  return check;
}

/// What the gaze was of, where the record says: the pointer's and a simulated eye's are no
/// person's.
std::string trackers_in_words(const std::vector<TrackedTrial>& trials) {
  std::set<std::string> trackers;
  for (const TrackedTrial& trial : trials) {
    if (!trial.gaze->tracker.empty()) {
      trackers.insert(trial.gaze->tracker);
    }
  }
  return trackers.empty() ? "" : fmt::format("; tracker: {}", fmt::join(trackers, ", "));
}

DataQualityCheck check_gaze_elsewhere(const std::vector<TrackedTrial>& trials) {
  DataQualityCheck check{
      "Trials with the gaze elsewhere", "the gaze or the object was not recorded",
      fmt::format("{:g} % of each trial’s time to its last mark with a valid gaze that is not on "
                  "the object, ours",
                  most_elsewhere_percent)};
  std::size_t known = 0;
  std::vector<std::string> elsewhere;
  for (const TrackedTrial& trial : trials) {
    if (const auto percent = percents_of(trial.gaze->figures.times).elsewhere) {
      ++known;
      if (*percent > most_elsewhere_percent) {
        elsewhere.push_back(fmt::format("{}: {:.0f} %", trial.name, *percent));
      }
    }
  }
  if (known > 0) {
    check.found =
        fmt::format("{} of {}{}{}{}", elsewhere.size(), counted(known, "trial"),
                    elsewhere.empty() ? "" : ": ", first_of(elsewhere), trackers_in_words(trials));
    check.verdict = within(elsewhere.empty());
  }
  return check;
}

std::vector<ReactionFloor> reaction_floors(const StudyTables& tables,
                                           const study::DataQualityRecords& quality) {
  std::map<std::string, std::vector<double>> presses;
  std::map<std::string, std::size_t> false_starts;
  for (const study::ReactionRow& row : quality.reactions) {
    std::vector<double>& own = presses[row.participant];
    if (row.early) {
      ++false_starts[row.participant];
    } else {
      own.push_back(row.seconds);
    }
  }
  std::vector<ReactionFloor> floors;
  const Dataset& set = tables.set;
  for (std::size_t i = 0; i < set.participants.size(); ++i) {
    const auto own = presses.find(set.participants[i]);
    if (own == presses.end()) {
      continue;
    }
    ReactionFloor floor{set.participants[i], own->second.size(), false_starts[set.participants[i]],
                        median(own->second)};
    for (const double seconds : measured_times(set, i)) {
      ++floor.marks;
      floor.within_floor += floor.median_s && seconds <= *floor.median_s ? 1 : 0;
    }
    floors.push_back(floor);
  }
  return floors;
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return "passed";
    case Verdict::flagged:
      return "flagged";
    case Verdict::unknown:
      break;
  }
  return "not recorded";
}

DataQualityReport check_data_quality(const StudyTables& tables,
                                     const study::DataQualityRecords& quality,
                                     const study::StudyRecords& records) {
  DataQualityReport report;
  report.catches = catch_figures(tables.set, records);
  report.outliers = outlying_times(tables.set);
  report.frames = analysed_frames(tables, quality);
  const std::vector<study::FrameFigures>& frames = report.frames;
  const GazeOfTrials gaze(records, quality.gaze);
  report.gaze = gaze_by_method(records, tables.set, gaze);
  const std::vector<TrackedTrial> tracked = tracked_trials(tables.set, records, gaze);
  report.checks = {
      check_kind(tables),
      check_frames(frames, "Frames that missed their refresh", "%", most_late_percent, "ours",
                   [](const auto& row) { return percent_of_frames(row, row.late); }),
      check_frames(frames, "Frames without a valid gaze", "%", most_untracked_percent, "ours",
                   [](const auto& row) { return percent_of_frames(row, row.untracked); }),
      check_frames(
          frames, "Latency, from the eye to the display", "ms", longest_latency_ms,
          "of 50 to 70 that Albert et al. 2017 tolerate",
          [](const auto& row) { return 1e3 * (row.mean_gaze_age_s + row.mean_to_display_s); }),
      check_frames(frames, "From a frame to the mark upon it, the longest", "ms",
                   longest_mark_gap_ms, "ours",
                   [](const auto& row) { return 1e3 * row.longest_mark_after_frame_s; }),
      check_validation(tables, quality),
      check_objects_in_view(tracked),
      check_gaze_elsewhere(tracked),
      check_order(tables.set),
      check_catches(report.catches),
      check_outliers(report.outliers)};
  report.reactions = reaction_floors(tables, quality);
  return report;
}

}  // namespace foveola::analysis
