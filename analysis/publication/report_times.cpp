#include <algorithm>

#include <fmt/format.h>

#include "analysis/publication/html.h"
#include "analysis/publication/report_parts.h"
#include "analysis/publication/report_sections.h"
#include "analysis/publication/wording.h"

namespace foveola::analysis {
namespace {

/// One number if it is the same for every method, else one for each, in the methods' order.
std::string count_per_method(const std::vector<std::size_t>& counts) {
  const bool same = std::all_of(counts.begin(), counts.end(),
                                [&](std::size_t count) { return count == counts.front(); });
  return same ? std::to_string(counts.front()) : fmt::format("{}", fmt::join(counts, " / "));
}

std::vector<std::string> scene_cells(const StudyTables& tables, Mark mark, std::size_t scene) {
  std::vector<std::string> row = {tables.set.scenes[scene]};
  std::vector<std::size_t> n;
  int censored = 0;
  int missing = 0;
  for (std::size_t method = 0; method < tables.set.methods.size(); ++method) {
    const SceneTimes& times = tables.scene_times_of(mark, scene, method);
    const Description& shown = method == baseline ? times.seconds : times.percent_of_baseline;
    const int decimals = method == baseline ? 2 : 1;
    row.push_back(fixed(shown.mean, decimals));
    row.push_back(fixed(shown.standard_deviation, decimals));
    n.push_back(shown.n);
    censored += times.censored;
    missing += times.missing;
  }
  row.push_back(count_per_method(n));
  row.push_back(std::to_string(censored));
  row.push_back(std::to_string(missing));
  return row;
}

std::string scene_times_table(const StudyTables& tables, Mark mark) {
  HtmlTable table;
  table.caption_html =
      caption_start(tables, fmt::format("Time until the {} was visible.", name_of(mark))) +
      escape_html(fmt::format(
          "{} in seconds; other methods in per cent of each participant’s own {} time in the same "
          "scene. Mean and standard deviation (sd) over n participants.",
          baseline_label(tables), baseline_label(tables)));
  table.groups.push_back({"", 1});
  table.columns.emplace_back("Scene");
  for (std::size_t method = 0; method < tables.set.methods.size(); ++method) {
    const std::string unit = method == baseline ? ", s" : ", %";
    table.groups.push_back({method_label(tables.set.methods[method]) + unit, 2});
    table.columns.insert(table.columns.end(), {"mean", "sd"});
  }
  table.groups.push_back({"Trials", 3});
  table.columns.insert(table.columns.end(), {"n", "right-censored", "missing"});
  for (std::size_t scene = 0; scene < tables.set.scenes.size(); ++scene) {
    table.rows.push_back(scene_cells(tables, mark, scene));
  }
  return render(table);
}

/// The other reading: the methods' means and deviations over the baseline's mean.
std::string of_baseline_mean_table(const StudyTables& tables, Mark mark) {
  HtmlTable table;
  const std::string reference = baseline_label(tables);
  table.caption_html =
      caption_start(tables, fmt::format("Until the {} was visible, of {}’s mean time.",
                                        name_of(mark), reference)) +
      escape_html(fmt::format("Mean time over participants in per cent of {}’s mean time in the "
                              "scene, and standard deviation (sd) in percentage points of it.",
                              reference));
  table.groups.push_back({"", 1});
  table.columns.emplace_back("Scene");
  for (std::size_t method = baseline + 1; method < tables.set.methods.size(); ++method) {
    table.groups.push_back({method_label(tables.set.methods[method]) + ", %", 2});
    table.columns.insert(table.columns.end(), {"mean", "sd"});
  }
  for (std::size_t scene = 0; scene < tables.set.scenes.size(); ++scene) {
    std::vector<std::string> row = {tables.set.scenes[scene]};
    for (std::size_t method = baseline + 1; method < tables.set.methods.size(); ++method) {
      const OfBaselineMean& times = tables.scene_times_of(mark, scene, method).of_baseline_mean;
      row.push_back(fixed(times.mean_percent, 1));
      row.push_back(fixed(times.sd_percent_points, 1));
    }
    table.rows.push_back(std::move(row));
  }
  return render(table);
}

std::string published_range(const StudyTables& tables, const std::vector<PublishedMean>& published,
                            const std::string& method) {
  const auto range = published_mean_of(published, tables.set.methods[baseline], method);
  return range ? fmt::format("{:g}–{:g}", range->low, range->high) : "–";
}

std::string method_times_table(const StudyTables& tables,
                               const std::vector<PublishedMean>& published) {
  HtmlTable table;
  table.caption_html =
      caption_start(tables, "Geometric means over scenes.") +
      escape_html(fmt::format("With 95 % intervals over n participants. The published column gives "
                              "the range of the published mean times (Koskela et al. 2018); the "
                              "paper does not say how its percentages were formed."));
  table.columns = {"Method and mark", "n", "seconds",
                   fmt::format("% of {}", baseline_label(tables)), "published, %"};
  for (const MethodTimes& times : tables.method_times) {
    table.rows.push_back({fmt::format("{}, {}", method_label(times.method), name_of(times.mark)),
                          std::to_string(times.participant_seconds.size()),
                          with_interval(times.seconds, 2),
                          with_interval(times.percent_of_baseline, 1),
                          published_range(tables, published, times.method)});
  }
  return render(table);
}

/// The end of a sentence: what the hollow points are, if there are any.
std::string points_in_words(const StudyTables& tables) {
  return tables.set.participants.size() > most_dots ? "."
                                                    : "; each hollow point is one participant.";
}

}  // namespace

std::string scenes_section(const StudyTables& tables) {
  std::string html =
      "<p>Table 2 of the published study. The outline mark says when a participant could tell "
      "whether moving or turning the chosen object had succeeded, the material mark when they "
      "could tell whether changing its material had.</p>\n"
      "<p>The paper does not say how its percentages and percentage points were formed. Both "
      "readings are here: each participant’s own ratio, then the ratio of means.</p>\n";
  for (const Mark mark : marks) {
    html += scene_times_table(tables, mark);
    if (tables.set.methods.size() > 1) {
      html += of_baseline_mean_table(tables, mark);
    }
  }
  return html_section("Time in each scene", html);
}

std::string methods_section(const StudyTables& tables, const std::vector<Figure>& figures,
                            const std::vector<PublishedMean>& published) {
  const std::string what_is_drawn =
      "Geometric mean over scenes and 95 % interval over participants" + points_in_words(tables);
  const std::string off_the_axis = " An interval may run off the axis; the table has it.";
  std::string html = "<p>Fig. 5 of the published study.</p>\n";
  html += figure_html(tables, figures, "figure5_relative",
                      fmt::format("Time relative to {}.", baseline_label(tables)),
                      what_is_drawn + " The dark vertical line is no change." + off_the_axis);
  html += figure_html(tables, figures, "figure5_seconds", "Time in seconds.",
                      what_is_drawn + off_the_axis);
  html += method_times_table(tables, published);
  if (tables.incomplete_scenes > 0) {
    html += fmt::format(
        "<p>Left out here, because not every method’s time was measured: {} of {} pairs of a "
        "participant and a scene, the two marks counted apart.</p>\n",
        tables.incomplete_scenes,
        tables.set.participants.size() * tables.set.scenes.size() * marks.size());
  }
  return html_section("Time over all scenes", html);
}

}  // namespace foveola::analysis
