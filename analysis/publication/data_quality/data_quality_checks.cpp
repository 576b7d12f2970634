#include "analysis/publication/data_quality/data_quality_checks.h"

#include <algorithm>
#include <map>
#include <span>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/publication/data_quality/gaze_sources.h"
#include "analysis/publication/data_quality/session_checks.h"
#include "analysis/statistics/models/order_balance.h"
#include "renderer/base/numbers/quantile.h"

namespace foveola::analysis {
namespace {

/// Returns each participant once, in the findings' order.
std::vector<std::string> participants_of(std::span<const Finding> findings) {
  std::vector<std::string> participants;
  for (const Finding& finding : findings) {
    if (std::ranges::find(participants, finding.participant) == participants.end()) {
      participants.push_back(finding.participant);
    }
  }
  return participants;
}

// These limits are Foveola's own: there are no published ones.
constexpr double least_balance_p = 0.01;
constexpr double max_false_alarms_percent = 20.0;
constexpr double max_censored_percent = 20.0;

/// Returns the positions of the methods in one scene of one participant. Empty unless each position
/// is taken once: a trial missing from the record has no position.
std::vector<std::size_t> positions_of_methods(std::span<const Trial> block) {
  std::vector<std::size_t> positions;
  for (const Trial& trial : block) {
    positions.push_back(static_cast<std::size_t>(trial.method_position));
  }
  std::vector<std::size_t> sorted = positions;
  std::ranges::sort(sorted);
  for (std::size_t position = 0; position < sorted.size(); ++position) {
    if (sorted[position] != position) {
      return {};
    }
  }
  return positions;
}

/// Counts how often each method had each position, over the participants' complete scenes.
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
    check.value_text = "no participant has all trials of a scene";
    return check;
  }
  check.value_text = fmt::format("each method {} to {} times in each place; P {}", balance->fewest,
                                 balance->most, p_value(balance->p));
  check.verdict = verdict_of(balance->p >= least_balance_p);
  return check;
}

DataQualityCheck check_kind(const StudyTables& tables) {
  const std::string warning = data_warning(tables);
  return {"People’s data", warning.empty() ? "only people’s sessions in the file" : warning,
          "no simulated and no pilot sessions", verdict_of(warning.empty())};
}

std::vector<double> measured_times(const Dataset& set, std::size_t participant) {
  std::vector<double> times;
  for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
    for (std::size_t method = 0; method < set.methods.size(); ++method) {
      for (const std::size_t mark : set.marks()) {
        if (const Value& time = set.value(participant, scene, method, mark); time.is_measured()) {
          times.push_back(time.number);
        }
      }
    }
  }
  return times;
}

/// Counts the catch trials of the analysed participants, by their final timings.
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
    for (const std::size_t mark : set.marks()) {
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
      fmt::format("{:g} % of each participant's, ours", max_false_alarms_percent)};
  if (catches.empty()) {
    return check;
  }
  std::size_t trials = 0;
  std::size_t false_alarms = 0;
  std::vector<std::string> above;
  for (const CatchFigures& row : catches) {
    trials += row.trials;
    false_alarms += row.false_alarms;
    if (row.false_alarms_percent() > max_false_alarms_percent) {
      above.push_back(row.participant);
    }
  }
  check.value_text =
      fmt::format("a mark in {} of {}{}", false_alarms, count_with_noun(trials, "catch trial"),
                  above.empty() ? "" : "; above the limit: " + comma_list(above));
  check.verdict = verdict_of(above.empty());
  return check;
}

DataQualityCheck check_outliers(const std::vector<OutlyingTime>& outliers) {
  std::vector<Finding> findings;
  for (const OutlyingTime& time : outliers) {
    findings.push_back({time.participant,
                        fmt::format("{}, {}, {}, {}: {:.2g} × the expected", time.participant,
                                    time.scene, time.method, time.mark, time.ratio_to_expected)});
  }
  return {
      "Outlying times",
      outliers.empty() ? "none" : fmt::format("{}{}", outliers.size(), findings_suffix(findings)),
      "none; by chance, one study in twenty has any (Rosner’s test, level 5 %, for each mark)",
      verdict_of(outliers.empty())};
}

/// Minimum time of a simple reaction to light (Luce 1986, Response Times).
constexpr double min_seen_s = 0.1;

DataQualityCheck check_early_marks(const Dataset& set) {
  std::vector<Finding> findings;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    const std::string& code = set.participants[participant];
    for (std::size_t scene = 0; scene < set.scenes.size(); ++scene) {
      for (std::size_t method = 0; method < set.methods.size(); ++method) {
        for (const std::size_t mark : set.marks()) {
          const Value& time = set.value(participant, scene, method, mark);
          if (time.is_measured() && time.number < min_seen_s) {
            findings.push_back(
                {code, fmt::format("{}, {}, {}, {}: {:.3f} s", code, set.scenes[scene],
                                   set.methods[method], set.measures[mark].id(), time.number)});
          }
        }
      }
    }
  }
  return {
      "Marks sooner than anybody can react",
      findings.empty() ? "none" : fmt::format("{}{}", findings.size(), findings_suffix(findings)),
      fmt::format("none before {:g} s, by simple reactions to light", min_seen_s),
      verdict_of(findings.empty())};
}

/// Where times are censored, complete cases and signed ranks favour the method with the censored
/// times.
DataQualityCheck check_time_outs(const Dataset& set) {
  const double trials = static_cast<double>(set.participants.size() * set.scenes.size());
  std::vector<std::string> found;
  double largest = 0.0;
  for (const std::size_t mark : set.marks()) {
    for (std::size_t method = 0; method < set.methods.size(); ++method) {
      const double percent = 100.0 * static_cast<double>(set.censored(mark, method)) / trials;
      largest = std::max(largest, percent);
      if (percent > 0.0) {
        found.push_back(fmt::format("{} with {} {:.1f} %", set.measures[mark].id(),
                                    method_label(set.methods[method]), percent));
      }
    }
  }
  return {"Right-censored times", found.empty() ? "none" : comma_list(found),
          fmt::format("{:g} % of any mark’s times with any method, ours", max_censored_percent),
          verdict_of(largest <= max_censored_percent)};
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

DataQualityReport check_data_quality(const StudyTables& tables,
                                     const study::DataQualityRecords& quality,
                                     const study::StudyRecords& records) {
  DataQualityReport report;
  report.catches = catch_figures(tables.set, records);
  report.outliers = outlying_times(tables.set);
  report.frames = of_analysed(tables.set, quality.frames);
  const GazeOfTrials gaze = gaze_of_trials(records, quality.gaze);
  report.gaze = gaze_by_method(records, tables.set, gaze);
  report.checks = {check_kind(tables)};
  const auto add = [&](const std::vector<DataQualityCheck>& checks) {
    report.checks.insert(report.checks.end(), checks.begin(), checks.end());
  };
  add({check_gaze_source(tables.set, quality.gaze)});
  add(check_frames(report.frames));
  add(check_gaze(tables.set, records, quality.gaze_runs, gaze));
  add(check_sessions(tables.set, records, quality));
  add({check_order(tables.set), check_time_outs(tables.set), check_catches(report.catches),
       check_early_marks(tables.set), check_outliers(report.outliers)});
  report.reactions = reaction_floors(tables, quality);
  return report;
}

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

Verdict verdict_of(bool is_within_limit) {
  return is_within_limit ? Verdict::passed : Verdict::flagged;
}

std::string findings_in_words(const std::vector<Finding>& findings) {
  constexpr std::size_t max_told = 5;
  const std::span<const Finding> all(findings);
  const std::size_t told = std::min(max_told, all.size());
  std::string text;
  for (const Finding& finding : all.first(told)) {
    text += (text.empty() ? "" : "; ") + finding.text;
  }
  const std::span<const Finding> others = all.subspan(told);
  return others.empty()
             ? text
             : fmt::format("{}; and {} of {}", text, count_with_noun(others.size(), "other"),
                           comma_list(participants_of(others)));
}

std::string findings_suffix(const std::vector<Finding>& findings) {
  return findings.empty() ? "" : ": " + findings_in_words(findings);
}

}  // namespace foveola::analysis
