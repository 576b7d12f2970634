#include "analysis/koskela2018/met_means.h"

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/own_cells.h"

namespace foveola::analysis {
namespace {

bool is_near(double times) { return times <= near_factor && times >= 1.0 / near_factor; }

/// Counts those of one reading and of the methods for which `is_counted`.
template <typename Condition>
MetMeans count_met(const std::vector<ComparedNumber>& numbers, const std::string& means,
                   const Condition& is_counted) {
  MetMeans met{.means = means};
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

}  // namespace

std::vector<MetMeans> count_met_means(const std::vector<ComparedNumber>& numbers) {
  std::vector<MetMeans> counts = {
      count_met(numbers, "Table 1",
                [](const ComparedNumber& number) { return number.source == "Table 1"; }),
      count_met(numbers, "Table 2, OD", [](const ComparedNumber& number) {
        return number.source == "Table 2" && number.method == "od";
      })};
  for (const Reading reading : {Reading::own_ratios, Reading::ratio_of_means}) {
    counts.push_back(count_met(numbers, fmt::format("Table 2, VP and FV, {}", name_of(reading)),
                               [&](const ComparedNumber& number) {
                                 return number.source == "Table 2" &&
                                        number.reading == name_of(reading);
                               }));
  }
  return counts;
}

std::string in_words(const MetMeans& met) {
  std::string text =
      fmt::format("{}: of {}, ", met.means, counted(met.published, "published mean"));
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
