#include "analysis/koskela2018/own_cells.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/profile.h"

namespace foveola::analysis {
namespace {

bool is_near(double times) { return times <= near_factor && times >= 1.0 / near_factor; }

template <typename Condition>
ReproducedMeans count_reproduced(const std::vector<ComparedNumber>& numbers,
                                 const std::string& means, const Condition& is_counted) {
  ReproducedMeans met{.means = means};
  for (const ComparedNumber& number : numbers) {
    if (!is_counted(number)) {
      continue;
    }
    const bool study_in = is_study_in_published_interval(number).value_or(false);
    const bool published_in = is_published_in_study_interval(number).value_or(false);
    ++met.published;
    met.compared += number.study ? 1 : 0;
    met.study_in_published_interval += study_in ? 1 : 0;
    met.published_in_study_interval += published_in ? 1 : 0;
    met.in_both_intervals += study_in && published_in ? 1 : 0;
    if (number.source != "Table 1") {
      const auto times = times_published(number);
      met.near = met.near.value_or(0) + (times && is_near(*times) ? 1 : 0);
    }
  }
  return met;
}

using Values = std::vector<std::optional<double>>;  ///< Of participants; some may be missing.

Values seconds_in(const Dataset& set, const OwnCell& cell) {
  Values values;
  for (std::size_t participant = 0; participant < set.participants.size(); ++participant) {
    const Value& time = set.value(participant, cell.scene, cell.method, cell.mark);
    values.push_back(time.is_measured() ? std::optional(time.number) : std::nullopt);
  }
  return values;
}

Values baseline_seconds_in(const Dataset& set, const OwnCell& cell) {
  return seconds_in(set, {cell.mark, cell.scene, baseline});
}

/// Returns each participant's time in per cent of their own with the baseline.
Values own_percent_in(const Dataset& set, const OwnCell& cell) {
  const Values references = baseline_seconds_in(set, cell);
  Values values = seconds_in(set, cell);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = values[i] && references[i] ? std::optional(100.0 * *values[i] / *references[i])
                                           : std::nullopt;
  }
  return values;
}

std::vector<double> present(const Values& values) {
  std::vector<double> result;
  for (const std::optional<double>& value : values) {
    if (value) {
      result.push_back(*value);
    }
  }
  return result;
}

}  // namespace

std::optional<std::size_t> mark_index(const Dataset& set, const std::string& mark) {
  const auto found = set.measure_named(mark);
  return found && set.measures[*found].kind == MeasureKind::time ? found : std::nullopt;
}

std::optional<std::size_t> scene_of(const Dataset& set, const PublishedTime& row) {
  const auto same = position_of(set.scenes, row.scene);
  return same ? same : position_of(set.scenes, row.counterpart);
}

std::optional<OwnCell> cell_of(const Dataset& set, const PublishedTime& row) {
  const auto mark = mark_index(set, row.mark);
  const auto scene = scene_of(set, row);
  const auto method = position_of(set.methods, row.method);
  return mark && scene && method && is_relative_to_od(set)
             ? std::optional(OwnCell{*mark, *scene, *method})
             : std::nullopt;
}

const char* name_of(Reading reading) {
  constexpr std::array names = {"", "own ratios", "ratio of means"};
  return names.at(static_cast<std::size_t>(reading));
}

std::vector<Reading> readings_of(const std::string& method) {
  return method == "od" ? std::vector{Reading::seconds}
                        : std::vector{Reading::own_ratios, Reading::ratio_of_means};
}

std::optional<LogOfMeans> log_mean_of_cell(const Dataset& set, const OwnCell& cell,
                                           Reading reading) {
  if (reading == Reading::own_ratios) {
    return log_of_mean(own_percent_in(set, cell));
  }
  const auto seconds = log_of_mean(seconds_in(set, cell));
  if (reading == Reading::seconds) {
    return seconds;
  }
  const auto reference = log_of_mean(baseline_seconds_in(set, cell));
  if (!seconds || !reference) {
    return std::nullopt;
  }
  LogOfMeans percent = log_of_ratio(*seconds, *reference);
  percent.value += std::log(100.0);
  return percent;
}

MeanAndDeviation mean_of_cell(const StudyTables& tables, const OwnCell& cell, Reading reading) {
  if (reading == Reading::ratio_of_means) {
    const auto ratio = log_mean_of_cell(tables.set, cell, reading);
    return {ratio ? std::optional(estimate_of(*ratio)) : std::nullopt,
            tables.scene_times_of(cell.mark, cell.scene, cell.method)
                .of_baseline_mean.sd_percent_points};
  }
  const std::vector<double> values =
      present(reading == Reading::seconds ? seconds_in(tables.set, cell)
                                          : own_percent_in(tables.set, cell));
  return {mean_estimate(values), standard_deviation(values)};
}

std::vector<ReproducedMeans> count_reproduced_means(const std::vector<ComparedNumber>& numbers) {
  std::vector<ReproducedMeans> counts = {
      count_reproduced(numbers, "Table 1",
                       [](const ComparedNumber& number) { return number.source == "Table 1"; }),
      count_reproduced(numbers, "Table 2, OD", [](const ComparedNumber& number) {
        return number.source == "Table 2" && number.method == "od";
      })};
  for (const Reading reading : {Reading::own_ratios, Reading::ratio_of_means}) {
    counts.push_back(
        count_reproduced(numbers, fmt::format("Table 2, VP and FV, {}", name_of(reading)),
                         [&](const ComparedNumber& number) {
                           return number.source == "Table 2" && number.reading == name_of(reading);
                         }));
  }
  return counts;
}

std::string in_words(const ReproducedMeans& met) {
  std::string text =
      fmt::format("{}: of {}, ", met.means, count_with_noun(met.published, "published mean"));
  if (met.compared < met.published) {
    text += fmt::format("{} of which this study has, ", met.compared);
  }
  if (met.near) {
    text += fmt::format("{} within {:g} times the published value, ", *met.near, near_factor);
  }
  return text +
         fmt::format("{} of ours in the published interval, {} of theirs in ours, {} in both.",
                     met.study_in_published_interval, met.published_in_study_interval,
                     met.in_both_intervals);
}

}  // namespace foveola::analysis
