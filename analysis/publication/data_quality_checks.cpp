#include "analysis/publication/data_quality_checks.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>

#include <boost/math/distributions/chi_squared.hpp>
#include <fmt/format.h>

#include "analysis/publication/wording.h"
#include "renderer/base/csv.h"

namespace foveola::analysis {
namespace {

// These limits are Foveola's own, for want of published ones, except that of the latency: at 50 to
// 70 ms people begin to notice foveation (Albert, Patney, Luebke, Kim 2017).
constexpr double most_late_percent = 1.0;
constexpr double most_untracked_percent = 10.0;
constexpr double longest_latency_ms = 50.0;
constexpr double longest_mark_gap_ms = 100.0;
constexpr double least_balance_p = 0.01;

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
std::vector<std::size_t> places_of_methods(std::span<const Cell> block) {
  std::vector<std::size_t> places;
  for (const Cell& cell : block) {
    places.push_back(static_cast<std::size_t>(cell.method_position));
  }
  std::vector<std::size_t> sorted = places;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t place = 0; place < sorted.size(); ++place) {
    if (sorted[place] != place) {
      return {};
    }
  }
  return places;
}

/// How often each method had each position, over the participants' scenes with all their trials.
struct PlaceCounts {
  std::vector<std::vector<double>> counts;  ///< [method][position]
  double blocks = 0.0;  ///< Pairs of a participant and a scene, each with one permutation.
};

PlaceCounts count_places(const AnalysisSet& set) {
  const std::size_t methods = set.methods.size();
  PlaceCounts found{std::vector<std::vector<double>>(methods, std::vector<double>(methods, 0.0))};
  const std::span<const Cell> cells(set.cells);
  for (std::size_t first = 0; first < cells.size(); first += methods) {
    const std::vector<std::size_t> places = places_of_methods(cells.subspan(first, methods));
    for (std::size_t method = 0; method < places.size(); ++method) {
      found.counts[method][places[method]] += 1.0;
    }
    found.blocks += places.empty() ? 0.0 : 1.0;
  }
  return found;
}

/// The probability that random orders are spread at least as unevenly. In each of b blocks the k
/// methods are permuted, so that a method has every place once in k blocks on average, with the
/// variance b (k - 1) / k^2 rather than the b / k of free counts: (k - 1) / k times Pearson's sum
/// of (O - E)^2 / E is chi-squared with (k - 1)^2 degrees of freedom (Anderson 1959, "Use of
/// contingency tables in the analysis of consumer preference studies", Biometrics 15).
double probability_of_places(const PlaceCounts& found) {
  const auto k = static_cast<double>(found.counts.size());
  const double expected = found.blocks / k;
  double pearson = 0.0;
  for (const std::vector<double>& row : found.counts) {
    for (const double count : row) {
      pearson += (count - expected) * (count - expected) / expected;
    }
  }
  const boost::math::chi_squared distribution((k - 1.0) * (k - 1.0));
  return boost::math::cdf(boost::math::complement(distribution, (k - 1.0) / k * pearson));
}

DataQualityCheck check_order(const AnalysisSet& set) {
  DataQualityCheck check{"Balance of the methods’ order", "one method",
                         fmt::format("no worse than chance at {:g}, ours", least_balance_p)};
  if (set.methods.size() < 2) {
    return check;
  }
  const PlaceCounts found = count_places(set);
  if (found.blocks == 0.0) {
    check.found = "no participant has all trials of a scene";
    return check;
  }
  double fewest = found.blocks;
  double most = 0.0;
  for (const std::vector<double>& row : found.counts) {
    fewest = std::min(fewest, *std::min_element(row.begin(), row.end()));
    most = std::max(most, *std::max_element(row.begin(), row.end()));
  }
  const double p = probability_of_places(found);
  check.found =
      fmt::format("each method {:g} to {:g} times in each place; P {}", fewest, most, p_value(p));
  check.verdict = within(p >= least_balance_p);
  return check;
}

DataQualityCheck check_kind(const StudyTables& tables) {
  const std::string warning = data_warning(tables);
  return {"People’s data", warning.empty() ? "only people’s sessions in the file" : warning,
          "no simulated and no pilot sessions", within(warning.empty())};
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
  const AnalysisSet& set = tables.set;
  for (std::size_t i = 0; i < set.participants.size(); ++i) {
    const auto own = presses.find(set.participants[i]);
    if (own == presses.end()) {
      continue;
    }
    ReactionFloor floor{set.participants[i], own->second.size(), false_starts[set.participants[i]],
                        median(own->second)};
    const std::size_t trials = set.scenes.size() * set.methods.size();
    for (std::size_t trial = 0; trial < trials; ++trial) {
      for (const MarkTime& time : set.cells[i * trials + trial].times) {
        const bool measured = time.state == MarkTime::State::measured;
        floor.marks += measured ? 1 : 0;
        floor.within_floor += measured && floor.median_s && time.seconds <= *floor.median_s ? 1 : 0;
      }
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
                                     const study::DataQualityRecords& quality) {
  DataQualityReport report;
  report.frames = analysed_frames(tables, quality);
  const std::vector<study::FrameFigures>& frames = report.frames;
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
      check_order(tables.set)};
  report.reactions = reaction_floors(tables, quality);
  return report;
}

std::string data_quality_csv(const DataQualityReport& report, const std::string& kind) {
  std::vector<CsvRow> rows = {{"check", "found", "limit", "verdict", "participant_kind"}};
  for (const DataQualityCheck& check : report.checks) {
    rows.push_back(
        {check.name, check.found, check.limit, std::string(name_of(check.verdict)), kind});
  }
  return format_csv(rows);
}

std::string latency_csv(const DataQualityReport& report, const std::string& kind) {
  std::vector<CsvRow> rows = {{"participant", "frames", "late_frames", "untracked_frames",
                               "mean_gaze_age_s", "mean_poll_to_display_s", "longest_frame_s",
                               "marks", "mean_frame_to_mark_s", "longest_frame_to_mark_s",
                               "participant_kind"}};
  for (const study::FrameFigures& row : report.frames) {
    rows.push_back({row.participant, std::to_string(row.frames), std::to_string(row.late),
                    std::to_string(row.untracked), csv_number(row.mean_gaze_age_s),
                    csv_number(row.mean_to_display_s), csv_number(row.longest_frame_s),
                    std::to_string(row.marks), csv_number(row.mean_mark_after_frame_s),
                    csv_number(row.longest_mark_after_frame_s), kind});
  }
  return format_csv(rows);
}

std::string reactions_csv(const DataQualityReport& report, const std::string& kind) {
  std::vector<CsvRow> rows = {{"participant", "presses", "false_starts", "median_s", "marks",
                               "marks_within_median", "participant_kind"}};
  for (const ReactionFloor& row : report.reactions) {
    rows.push_back({row.participant, std::to_string(row.presses), std::to_string(row.false_starts),
                    csv_number(row.median_s), std::to_string(row.marks),
                    std::to_string(row.within_floor), kind});
  }
  return format_csv(rows);
}

}  // namespace foveola::analysis
