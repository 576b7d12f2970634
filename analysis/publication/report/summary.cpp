#include "analysis/publication/report/summary.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/profile.h"
#include "analysis/publication/report/printed_results.h"
#include "analysis/publication/tables/result_tables.h"
#include "renderer/base/text/utf8.h"

namespace foveola::analysis {
namespace {

/// Returns "for scenes like these 5" or "in these 4 of 5 scenes": the scenes of a result.
std::string scenes_in_words(const PrimaryResult& result, const StudyTables& tables,
                            const study::AnalysisPlan& plan) {
  const std::size_t all = tables.set.scenes.size();
  const std::string count = result.scenes == all
                                ? count_with_noun(all, "scene")
                                : fmt::format("{} of {} scenes", result.scenes, all);
  const bool is_of_others =
      result.scenes > 1 &&
      (result.kind == AnalysisKind::crossed_model ||
       (result.kind == AnalysisKind::tobit_model && plan.scenes == study::SceneEffects::random));
  return is_of_others ? "for scenes like these, from " + count : "in " + count;
}

/// Returns "right-censored: 23 of 80 times of OD, 1 of 80 of FV"; empty if there are none.
std::string censored_in_words(const StudyTables& tables, std::size_t mark, std::size_t method) {
  const Dataset& set = tables.set;
  const std::size_t trials = set.participants.size() * set.scenes.size();
  const std::size_t of_baseline = set.censored(mark, baseline);
  const std::size_t of_method = set.censored(mark, method);
  return of_baseline + of_method == 0
             ? ""
             : fmt::format("; right-censored: {} of {} times of {}, {} of {} of {}", of_baseline,
                           trials, method_label(set.methods[baseline]), of_method, trials,
                           method_label(set.methods[method]));
}

Headline headline_of(const MethodComparison& row, std::size_t mark, std::size_t method,
                     const StudyTables& tables, const study::AnalysisPlan& plan) {
  const Dataset& set = tables.set;
  Headline finding{.before = method_label(set.methods[method]) + " took"};
  const std::string of_what =
      fmt::format("of {}’s time until {}", method_label(set.methods[baseline]),
                  moment_of(set, set.measures[mark]));
  if (!row.primary) {
    finding.value = "an unknown share";
    finding.after =
        fmt::format("{} ({}{})", of_what, row.missing, censored_in_words(tables, mark, method));
    return finding;
  }
  const PrimaryResult& result = *row.primary;
  const double sign = row.reference == set.methods[baseline] ? 1.0 : -1.0;
  Estimate percent{.value = 100.0 * std::exp(sign * result.estimate)};
  if (result.interval) {
    const auto [low, high] =
        std::minmax({sign * result.interval->low, sign * result.interval->high});
    percent.interval = {100.0 * std::exp(low), 100.0 * std::exp(high)};
  }
  finding.value = with_interval(percent, 1) + " %";
  finding.after = fmt::format("{} {} ({}{}{})", of_what, scenes_in_words(result, tables, plan),
                              name_of(result.kind),
                              result.instead.empty() ? "" : ", a stand-in: " + result.instead,
                              censored_in_words(tables, mark, method));
  return finding;
}

/// Returns the table for the terminal, without the note, which the report has.
std::string block(const StudyTables& tables, PrintedTable table) {
  table.note.clear();
  return fmt::format("\n{}", plain_text_of(table, data_notice(tables)));
}

}  // namespace

std::string terminal_summary(const StudyTables& tables, const std::vector<Table>& results,
                             const Comparisons& comparisons, const Background& background,
                             const std::optional<PublishedStudy>& published) {
  std::string text =
      fmt::format("{}: {}, {}, {}\n", printable(tables.protocol_name),
                  participants_in_words(tables), count_with_noun(tables.set.scenes.size(), "scene"),
                  count_with_noun(tables.set.methods.size(), "method"));
  for (const Headline& finding : headlines(tables, comparisons)) {
    text += fmt::format("  {}.\n", printable(finding.sentence()));
  }
  for (const std::size_t mark : tables.set.times()) {
    text += block(tables, printed_times(tables, mark, published));
  }
  text += fmt::format(
      "  Mean ± standard deviation; % of each participant's own {} time. The last row: geometric\n"
      "  mean over scenes with a 95 % confidence interval over participants.\n",
      printable(method_label(tables.set.methods[baseline])));
  if (const std::string censored = censored_times_in_words(tables.set); !censored.empty()) {
    text += fmt::format("  {}\n", printable(censored));
  }
  if (published) {
    text += block(tables, printed_geometric_means(tables, published));
  }
  for (const std::size_t rating : tables.set.ratings()) {
    const Measure& measure = tables.set.measures[rating];
    PrintedTable table = printed_ratings(tables, rating);
    table.title = fmt::format("Ratings: {}, {}", measure.id(), study::scale_in_words(measure));
    text += block(tables, std::move(table));
  }
  if (published) {
    text += block(tables, printed_background_answers(background, published));
  }
  if (background.correlation) {
    PrintedTable table = printed_background(tables, table_named(results, "background_correlation"));
    table.title = fmt::format("Background ({}) against speed-up", comma_list(background.scale));
    text += block(tables, std::move(table));
  }
  return text;
}

std::vector<Headline> headlines(const StudyTables& tables, const Comparisons& comparisons) {
  const Dataset& set = tables.set;
  std::vector<Headline> findings;
  for (std::size_t method = baseline + 1; method < set.methods.size(); ++method) {
    for (const std::size_t mark : set.marks()) {
      const auto row =
          std::ranges::find_if(comparisons.methods, [&](const MethodComparison& found) {
            return found.measure == set.measures[mark].id() &&
                   std::minmax(found.method, found.reference) ==
                       std::minmax(set.methods[method], set.methods[baseline]);
          });
      if (row != comparisons.methods.end()) {
        findings.push_back(headline_of(*row, mark, method, tables, comparisons.plan));
      }
    }
  }
  return findings;
}

}  // namespace foveola::analysis
