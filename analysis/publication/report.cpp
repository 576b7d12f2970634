#include "analysis/publication/report.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "analysis/publication/html.h"
#include "analysis/publication/inline_svg.h"
#include "analysis/publication/report_style.h"
#include "analysis/publication/wording.h"
#include "renderer/base/build_info.h"

namespace foveola::analysis {
namespace {

std::string baseline_label(const StudyTables& tables) {
  return method_label(tables.set.methods[baseline]);
}

/// HTML for the start of every caption: what it is, and whose data it shows.
std::string caption_start(const StudyTables& tables, std::string_view title) {
  const std::string notice = data_notice(tables);
  const std::string tag =
      notice.empty() ? "" : fmt::format("<span class=\"tag\">{}</span>", escape_html(notice));
  return fmt::format("{}<strong>{}</strong> ", tag, escape_html(title));
}

std::string figure_html(const StudyTables& tables, const std::vector<Figure>& figures,
                        std::string_view name, std::string_view title,
                        std::string_view explanation) {
  const auto figure = std::find_if(figures.begin(), figures.end(),
                                   [&](const Figure& candidate) { return candidate.name == name; });
  if (figure == figures.end()) {
    return "";
  }
  const std::string description =
      fmt::format("{} {} The table has the numbers.", title, data_notice(tables));
  return fmt::format("<figure>\n{}<figcaption>{}{}</figcaption>\n</figure>\n",
                     inline_svg(figure->svg, figure->name, description),
                     caption_start(tables, title), escape_html(explanation));
}

std::string methods_in_words(const StudyTables& tables) {
  std::vector<std::string> methods;
  for (const std::string& method : tables.set.methods) {
    const std::string_view meaning = method_meaning(method);
    methods.push_back(meaning.empty() ? method
                                      : fmt::format("{} ({})", method_label(method), meaning));
  }
  return listed(methods);
}

std::string header_html(const StudyTables& tables) {
  const std::string& title =
      tables.protocol_title.empty() ? tables.protocol_name : tables.protocol_title;
  const std::string warning = data_warning(tables);
  std::string html = fmt::format(
      "<header>\n<p class=\"eyebrow\">Foveola study report</p>\n<h1>{}</h1>\n{}",
      escape_html(title),
      warning.empty()
          ? ""
          : fmt::format("<p class=\"notice\" role=\"note\">{}</p>\n", escape_html(warning)));
  const auto fact = [&](std::string_view term, const std::string& value_html) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", term, value_html);
  };
  html += "<dl class=\"facts\">\n";
  fact("Protocol", escape_html(tables.protocol_name));
  fact("SHA-256 of the protocol",
       fmt::format("<code>{}</code>", escape_html(tables.protocol_sha256)));
  fact("Analysed", escape_html(participants_in_words(tables)));
  fact("Scenes", escape_html(listed(tables.set.scenes)));
  fact("Methods",
       escape_html(methods_in_words(tables) + "; compared with " + baseline_label(tables)));
  return html + "</dl>\n</header>\n";
}

std::string findings_html(const StudyTables& tables) {
  std::string items;
  for (std::size_t method = baseline + 1; method < tables.set.methods.size(); ++method) {
    for (const Mark mark : marks) {
      const MethodTimes& times = tables.method_times_of(mark, method);
      if (times.percent_of_baseline) {
        items += fmt::format(
            "<li>{} took <strong>{} %</strong> of {}’s time until the {} was visible.</li>\n",
            escape_html(method_label(times.method)),
            escape_html(with_interval(times.percent_of_baseline, 1)),
            escape_html(baseline_label(tables)), name_of(mark));
      }
    }
  }
  return items.empty() ? ""
                       : "<ul class=\"findings\">\n" + items +
                             "</ul>\n<p>Geometric means over scenes, with 95 % intervals over "
                             "participants in brackets.</p>\n";
}

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
  table.columns.insert(table.columns.end(), {"n", "timed out", "missing"});
  for (std::size_t scene = 0; scene < tables.set.scenes.size(); ++scene) {
    table.rows.push_back(scene_cells(tables, mark, scene));
  }
  return render(table);
}

std::string scenes_section(const StudyTables& tables) {
  std::string html =
      "<p>Table 2 of the published study. The outline mark says when a participant could tell "
      "whether moving or turning the chosen object had succeeded, the material mark when they "
      "could tell whether changing its material had.</p>\n";
  for (const Mark mark : marks) {
    html += scene_times_table(tables, mark);
  }
  return html_section("Time in each scene", html);
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

std::string methods_section(const StudyTables& tables, const std::vector<Figure>& figures,
                            const std::vector<PublishedMean>& published) {
  std::string html = "<p>Fig. 5 of the published study.</p>\n";
  html += figure_html(
      tables, figures, "figure5_relative",
      fmt::format("Time relative to {}.", baseline_label(tables)),
      "Geometric mean over scenes and 95 % interval over participants; each pale dot is one "
      "participant. The dark vertical line is no change. An interval "
      "may run off the axis; the table has it.");
  html +=
      figure_html(tables, figures, "figure5_seconds", "Time in seconds.",
                  "Geometric mean over scenes and 95 % interval over participants; each pale "
                  "dot is one participant. An interval may run off the axis; the table has it.");
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

std::string ratings_section(const StudyTables& tables, const std::vector<Figure>& figures) {
  HtmlTable table;
  table.caption_html = caption_start(tables, "Artifact ratings.") +
                       "How many answers were 1 (none) to 5 (not discernible at all).";
  table.groups = {{"", 1}, {"Answers", 6}, {"Summary", 3}};
  table.columns = {"Method", "1", "2", "3", "4", "5", "missing", "mean", "sd", "median"};
  for (const MethodRatings& ratings : tables.ratings) {
    std::vector<std::string> row = {method_label(ratings.method)};
    for (const int count : ratings.counts) {
      row.push_back(std::to_string(count));
    }
    row.push_back(std::to_string(ratings.missing));
    row.push_back(fixed(ratings.rating.mean, 2));
    row.push_back(fixed(ratings.rating.standard_deviation, 2));
    row.push_back(fixed(ratings.rating.median, 1));
    table.rows.push_back(std::move(row));
  }
  const std::string intro =
      "<p>Fig. 6 of the published study: how disturbing artifacts were in the areas other than "
      "the chosen object. Means treat the steps of the scale as equal, as the "
      "published study did; the distribution stands beside them because they need not be.</p>\n";
  return html_section(
      "Artifacts in other areas",
      intro +
          figure_html(tables, figures, "figure6_artifact_ratings",
                      "Artifact ratings, all scenes and participants.",
                      "Bars: the share of each answer, 1 none to 5 not discernible at all, with "
                      "its count. At the right: mean ± standard deviation.") +
          render(table));
}

std::string background_scale_in_words(const BackgroundScale& scale) {
  if (scale.questions.empty()) {
    return "The study asked no background question on a scale of five points, so there is nothing "
           "to correlate.";
  }
  const std::string questions = listed(scale.questions);
  return scale.as_published
             ? fmt::format(
                   "Background is the mean of the answers to {}, as in the published "
                   "study.",
                   questions)
             : fmt::format(
                   "Background is the mean of the answers to every five-point question "
                   "({}): the study did not ask both of the published study’s, "
                   "offline_rendering and virtual_reality.",
                   questions);
}

std::vector<std::string> correlation_row(const BackgroundCorrelation& row,
                                         const std::string& reference) {
  const std::string name =
      fmt::format("{} − {}, {}", reference, method_label(row.method), name_of(row.mark));
  const std::string n = std::to_string(row.participants);
  if (!row.correlation) {
    return {name, n, "–", "–", "–", "–"};
  }
  const Correlation& found = *row.correlation;
  const std::string interval =
      found.interval ? fmt::format("[{:.2f}, {:.2f}]", found.interval->low, found.interval->high)
                     : "–";
  return {name, n, fixed(found.r, 2), interval, fixed(found.t, 2), p_value(found.p)};
}

std::string background_section(const StudyTables& tables) {
  std::string html =
      fmt::format("<p>{}</p>\n", escape_html(background_scale_in_words(tables.background)));
  if (tables.background.questions.empty()) {
    return html_section("Background and speed-up", html);
  }
  HtmlTable table;
  table.caption_html =
      caption_start(tables, "Pearson correlation of background with the seconds saved.") +
      "Seconds saved are each participant’s mean over scenes. The interval is for r, 95 %; P is "
      "two-sided. A dash: not defined, because of fewer than three participants or constant "
      "values.";
  table.columns = {"Seconds saved", "n", "r", "95 % interval", "t", "P"};
  for (const BackgroundCorrelation& row : tables.background_correlations) {
    table.rows.push_back(correlation_row(row, baseline_label(tables)));
  }
  return html_section("Background and speed-up", html + render(table));
}

std::string exclusions_section(const StudyTables& tables) {
  constexpr std::size_t most_rows = 100;
  const std::vector<Exclusion>& exclusions = tables.set.exclusions;
  if (exclusions.empty()) {
    return html_section("What was left out",
                        "<p>Nothing: every session was completed and every value is there.</p>\n");
  }
  std::map<std::string, std::size_t> counts;
  for (const Exclusion& exclusion : exclusions) {
    ++counts[exclusion.reason];
  }
  std::string html = "<ul>\n";
  for (const auto& [reason, count] : counts) {
    html += fmt::format("<li>{} × {}</li>\n", count, escape_html(reason));
  }
  html += "</ul>\n";
  HtmlTable table;
  table.numeric = false;
  table.caption_html = caption_start(tables, "Left out, one by one.") + "A dash means all.";
  table.columns = {"Participant", "Scene", "Method", "Measure", "Reason"};
  const auto or_all = [](const std::string& text) { return text.empty() ? "–" : text; };
  for (std::size_t i = 0; i < std::min(most_rows, exclusions.size()); ++i) {
    const Exclusion& row = exclusions[i];
    table.rows.push_back({row.participant, or_all(row.scene),
                          or_all(row.method.empty() ? "" : method_label(row.method)),
                          or_all(row.measure), row.reason});
  }
  html += render(table);
  if (exclusions.size() > most_rows) {
    html += fmt::format("<p>And {} more in <code>exclusions.csv</code>.</p>\n",
                        exclusions.size() - most_rows);
  }
  return html_section("What was left out", html);
}

std::string definitions_section(const StudyTables& tables) {
  std::string html = "<dl class=\"definitions\">\n";
  const auto define = [&](std::string_view term, const std::string& meaning) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", term, escape_html(meaning));
  };
  const std::string reference = baseline_label(tables);
  define("Time", "From the first presented frame to the participant’s mark, in seconds.");
  define("Sessions",
         "Only completed sessions count, and only of one kind: people’s if there are any, else "
         "pilots’, else simulated ones.");
  define("Mean and standard deviation",
         "Of times: arithmetic, over participants; n − 1 in the denominator.");
  define("Per cent of " + escape_html(reference),
         fmt::format("100 × a participant’s time divided by the same participant’s {} time in the "
                     "same scene; a participant without both is not in n.",
                     reference));
  define("Timed out",
         "The participant never marked: the time is only a lower bound (right-censored). It is in "
         "no mean, which makes that method’s mean too small; the count stands beside it.");
  define("Geometric mean over scenes",
         "exp of the mean logarithm, first over a participant’s scenes, then over participants. A "
         "scene counts for a participant only if every method’s time was measured in it, so that "
         "the methods are compared over the same scenes.");
  define("95 % interval",
         "exp(m ± t·s/√n), with m and s the mean and standard deviation of the participants’ "
         "logarithms and t Student’s with n − 1 degrees of freedom: the participant is the unit.");
  define(
      "Seconds saved",
      fmt::format("A participant’s mean over scenes of {}’s time minus the method’s.", reference));
  define("P",
         "Of no correlation, two-sided: t = r·√((n − 2)/(1 − r²)), n − 2 degrees of freedom. "
         "The interval of r is Fisher’s z. None is corrected for the number of comparisons.");
  return html_section("Definitions", html + "</dl>\n");
}

std::string citation_section() {
  return html_section(
      "How to cite",
      "<p>M. K. Koskela, K. V. Immonen, T. T. Viitanen, P. O. Jääskeläinen, J. I. Multanen, "
      "J. H. Takala. “Instantaneous foveated preview for progressive Monte Carlo rendering.” "
      "<cite>Computational Visual Media</cite> 4(3), 267–276, 2018. "
      "<a "
      "href=\"https://doi.org/10.1007/s41095-018-0113-0\">doi:10.1007/s41095-018-0113-0</a></p>\n"
      "<p>Name the protocol and its SHA-256 with every result, so that others can run the same "
      "study.</p>\n");
}

}  // namespace

std::string report_html(const StudyTables& tables, const std::vector<Figure>& figures,
                        const std::vector<PublishedMean>& published) {
  const std::string& title =
      tables.protocol_title.empty() ? tables.protocol_name : tables.protocol_title;
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{} – Foveola study report</title>\n<link rel=\"icon\" href=\"data:,\">\n"
      "<style>{}</style>\n</head>\n<body>\n"
      "{}<main>\n{}{}{}{}{}{}{}{}</main>\n"
      "<footer>Foveola {}. The numbers are in the CSV files beside this report, at full "
      "precision.</footer>\n</body>\n</html>\n",
      escape_html(title), report_style(), header_html(tables), findings_html(tables),
      scenes_section(tables), methods_section(tables, figures, published),
      ratings_section(tables, figures), background_section(tables), exclusions_section(tables),
      definitions_section(tables), citation_section(), build_info().version);
}

}  // namespace foveola::analysis
