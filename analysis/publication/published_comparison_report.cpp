#include "analysis/publication/published_comparison_report.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "analysis/dataset/wording.h"
#include "analysis/koskela2018/own_cells.h"
#include "analysis/koskela2018/paper_notes.h"
#include "analysis/koskela2018/profile.h"
#include "analysis/publication/output_folder.h"
#include "analysis/publication/report_parts.h"
#include "analysis/tables/html.h"
#include "analysis/tables/printed_table.h"
#include "analysis/tables/table_formats.h"
#include "renderer/base/files/files.h"

namespace fs = std::filesystem;
namespace foveola::analysis {
namespace {

std::string name_of_row(const PublishedScene& original, const std::string& scene) {
  return original.is_counterpart
             ? fmt::format("published: {} (counterpart: {})", original.name, scene)
             : fmt::format("published: {}", original.name);
}

std::string mean_and_deviation(const PublishedTime* time) {
  Description shown;
  if (time != nullptr) {
    shown.mean = time->mean;
    shown.standard_deviation = time->standard_deviation;
  }
  return mean_and_deviation(shown, 1);
}

std::string or_dash(const std::string& text) { return text.empty() ? "–" : text; }

std::string method_or_dash(const std::string& method) {
  return or_dash(method.empty() ? "" : method_label(method));
}

/// How the numbers of a row are written.
enum class Format : std::uint8_t { count, p, two_decimals, one_decimal };

Format format_of(const ComparedNumber& number) {
  if (number.source == "Table 1") {
    return Format::two_decimals;
  }
  if (number.source == "text" && !number.mark.empty() && number.unit.empty()) {
    return Format::p;
  }
  return number.source == "text" && number.mark.empty() ? Format::count : Format::one_decimal;
}

int decimals_of(Format format) {
  constexpr std::array decimals = {0, 3, 2, 1};
  return decimals.at(static_cast<std::size_t>(format));
}

std::string with_unit(const std::string& value, const ComparedNumber& number) {
  return number.unit.empty() ? value : value + " " + number.unit;
}

/// What the text states is written as there.
std::string published_value(const ComparedNumber& number) {
  return with_unit(number.source == "text"
                       ? fmt::format("{:g}", number.published.value)
                       : with_interval(number.published, decimals_of(format_of(number))),
                   number);
}

std::string study_value(const ComparedNumber& number) {
  if (!number.study) {
    return "–";
  }
  const Format format = format_of(number);
  return with_unit(format == Format::p ? p_value(number.study->value)
                                       : with_interval(number.study, decimals_of(format)),
                   number);
}

std::string yes_or_no(std::optional<bool> truth) { return !truth ? "–" : *truth ? "yes" : "no"; }

std::vector<std::string> row_of_number(const ComparedNumber& number) {
  const int decimals = decimals_of(format_of(number));
  return {number.row,
          or_dash(number.own_row),
          or_dash(number.mark),
          method_or_dash(number.method),
          or_dash(number.reading),
          published_value(number),
          study_value(number),
          with_sign(difference_of(number), decimals),
          fixed(times_published(number), 2),
          yes_or_no(is_study_in_published_interval(number)),
          yes_or_no(is_published_in_study_interval(number)),
          fixed(number.published_deviation, decimals),
          fixed(number.study_deviation, decimals),
          with_sign(difference_of_deviations(number), decimals)};
}

/// The table without those columns, but the first, that have no value in any row.
PrintedTable without_empty_columns(PrintedTable table) {
  for (std::size_t column = table.columns.size() - 1; column > 0; --column) {
    const auto is_empty = [&](const std::vector<std::string>& row) { return row[column] == "–"; };
    if (std::all_of(table.rows.begin(), table.rows.end(), is_empty)) {
      const auto at = static_cast<std::ptrdiff_t>(column);
      table.columns.erase(table.columns.begin() + at);
      for (std::vector<std::string>& row : table.rows) {
        row.erase(row.begin() + at);
      }
    }
  }
  return table;
}

/// The numbers of one source as a table; a column without anything in it is left out.
std::string table_of(const StudyTables& tables, const std::vector<ComparedNumber>& numbers,
                     const std::string& source, const std::string& title,
                     const std::string& explanation) {
  PrintedTable table;
  table.title = title;
  table.note = explanation;
  table.columns = {"Published",
                   "This study’s",
                   "Mark",
                   "Method",
                   "Reading",
                   "Published value [95 %]",
                   "This study [95 %]",
                   "Difference",
                   "Times the published",
                   "Ours in theirs",
                   "Theirs in ours",
                   "Published SD",
                   "This study’s SD",
                   "Difference of SDs"};
  for (const ComparedNumber& number : numbers) {
    if (number.source == source) {
      table.rows.push_back(row_of_number(number));
    }
  }
  return html_of(without_empty_columns(std::move(table)), data_notice(tables));
}

std::string counts_html(const std::vector<ComparedNumber>& numbers) {
  std::string items;
  for (const MetMeans& met : count_met_means(numbers)) {
    items += fmt::format("<li>{}</li>\n", escape_html(in_words(met)));
  }
  return "<ul class=\"findings\">\n" + items + "</ul>\n";
}

constexpr const char* introduction =
    "Every number of the paper’s Tables 1 and 2, and what its sections 5 to 5.2 state in numbers, "
    "beside this study’s. A published interval is ours: mean ∓ t(15)·SD/4 from the printed mean "
    "and standard deviation and the 16 participants of section 5, as if the values had been drawn "
    "from a normal distribution; nothing is cut off, so its low end may be negative where times "
    "are skewed. This study’s intervals are over participants: Student’s t for means, the delta "
    "method on the logarithm for ratios of means and for geometric means over scenes. Standard "
    "deviations have no interval. The paper does not say how its percentages and percentage "
    "points were formed, so each stands in two readings: the mean and deviation of each "
    "participant’s own ratio, and the ratio of means with the deviation over OD’s mean. Neither "
    "is claimed to be the published one.";

/// The study's records compared with the paper.
struct Comparison {
  StudyTables tables;
  std::vector<ComparedNumber> numbers;
};

Comparison compare_study(const fs::path& database) {
  const PublishedStudy published = read_published_study(resource_folder() / "data" / "koskela2018");
  const study::StudyRecords records = study::read_study(database);
  Comparison comparison{tabulate_study(records), {}};
  comparison.numbers = compare_with_published(records, comparison.tables, published);
  return comparison;
}

}  // namespace

Table published_comparison_table(const StudyTables& tables,
                                 const std::vector<ComparedNumber>& numbers) {
  using Number = ComparedNumber;
  using enum ColumnType;
  const auto low = [](const Estimate& estimate) {
    return field_in(estimate.interval, [](const Interval& ends) { return ends.low; });
  };
  const auto high = [](const Estimate& estimate) {
    return field_in(estimate.interval, [](const Interval& ends) { return ends.high; });
  };
  const auto truth_of = [](std::optional<bool> value) { return value ? field(*value) : Field(); };
  const ColumnsOf<Number> columns = {
      {{"source", text, "", "Table 1 or 2 of the paper, its geometric means over scenes, or text"},
       [](const Number& number) { return field(number.source); }},
      {{"section", text, "", "Section of the paper"},
       [](const Number& number) { return field(number.section); }},
      {{"row", text, "", "The paper's question or scene, or what its text states"},
       [](const Number& number) { return field(number.row); }},
      {{"own_row", text, "", "This study's question or scene that is compared"},
       [](const Number& number) { return field(number.own_row); }},
      {{"mark", text, "", "Id of the mark"},
       [](const Number& number) { return field(number.mark); }},
      {{"method", text, "", "Id of the method"},
       [](const Number& number) { return field(number.method); }},
      {{"reading", text, "", "How this study's number was formed"},
       [](const Number& number) { return field(number.reading); }},
      {{"unit", text, "", "Unit of the values; of deviations of percentages, percentage points"},
       [](const Number& number) { return field(number.unit); }},
      {{"published", number, "", "Number of the paper, or computed from Table 2"},
       [](const Number& number) { return field(number.published.value); }},
      {{"published_ci95_low", number, "", "Lower end of its 95 % interval, which is ours"},
       [&](const Number& number) { return low(number.published); }},
      {{"published_ci95_high", number, "", "Upper end of its 95 % interval, which is ours"},
       [&](const Number& number) { return high(number.published); }},
      {{"published_sd", number, "", "Standard deviation in the paper"},
       [](const Number& number) { return field(number.published_deviation); }},
      {{"study", number, "", "This study's number"},
       [](const Number& number) {
         return field_in(number.study, [](const Estimate& own) { return own.value; });
       }},
      {{"study_ci95_low", number, "", "Lower end of its 95 % interval over participants"},
       [&](const Number& number) { return number.study ? low(*number.study) : Field(); }},
      {{"study_ci95_high", number, "", "Upper end of its 95 % interval over participants"},
       [&](const Number& number) { return number.study ? high(*number.study) : Field(); }},
      {{"study_sd", number, "", "This study's standard deviation"},
       [](const Number& number) { return field(number.study_deviation); }},
      {{"study_n", whole, "", "Participants in this study's number"},
       [](const Number& number) {
         return field_in(number.study, [](const Estimate& own) { return own.n; });
       }},
      {{"difference", number, "", "This study's number less the published one"},
       [](const Number& number) { return field(difference_of(number)); }},
      {{"times_published", number, "", "This study's time or factor over the published one"},
       [](const Number& number) { return field(times_published(number)); }},
      {{"difference_of_sds", number, "", "This study's deviation less the published one"},
       [](const Number& number) { return field(difference_of_deviations(number)); }},
      {{"study_in_published_ci95", truth, "",
        "Whether this study's lies in the published interval"},
       [&](const Number& number) { return truth_of(is_study_in_published_interval(number)); }},
      {{"published_in_study_ci95", truth, "",
        "Whether the published lies in this study's interval"},
       [&](const Number& number) { return truth_of(is_published_in_study_interval(number)); }},
      {{"participant_kind", text, "", "Who took part: human, pilot or simulated"},
       [&](const Number& /*number*/) { return field(tables.set.kind); }}};
  return tabulate("published_comparison", "number of the paper", columns, numbers);
}

std::string comparison_html(const StudyTables& tables, const std::vector<ComparedNumber>& numbers) {
  const std::string content =
      paragraph_html(introduction) + counts_html(numbers) +
      table_of(tables, numbers, "Table 2, all scenes", "Over all scenes.",
               "Published is the geometric mean over scenes of Table 2’s means, which we compute: "
               "the paper draws its own in Fig. 5, without numbers. This study’s is formed "
               "likewise, if it has all five scenes or their counterparts; the last reading is the "
               "geometric mean over participants and all its scenes, which its report has.") +
      table_of(tables, numbers, "Table 2", "Table 2: times in each scene.",
               "Deviations and differences of percentages are in percentage points. A published "
               "scene that this study does not show is compared with Foveola’s own counterpart of "
               "it, which is another scene.") +
      table_of(tables, numbers, "Table 1", "Table 1: background.",
               "Means and standard deviations over participants.") +
      table_of(tables, numbers, "text", "What the text states.",
               "Of participants (section 5), of background and the time saved (5.1; it says "
               "neither of which mark, nor how times were averaged, nor which correlation P is "
               "of), and of times over all scenes (5.2: around 10 %, 10 and 3 times). What it "
               "states of the machine (5.5, 5.6), no participant’s record measures.") +
      paragraph_html(artifacts_in_order(tables));
  return report_page(tables, "Beside the published study", content);
}

std::string comparison_summary(const StudyTables& tables,
                               const std::vector<ComparedNumber>& numbers) {
  std::string text;
  for (const ComparedNumber& number : numbers) {
    if (number.source == "Table 2, all scenes" && number.reading == "geometric mean") {
      text += fmt::format(
          "{} until the {}, over all scenes: {}; published {} (geometric mean over scenes of Table "
          "2)\n",
          method_label(number.method), number.mark, study_value(number), published_value(number));
    }
  }
  for (const MetMeans& met : count_met_means(numbers)) {
    text += in_words(met) + "\n";
  }
  const std::string artifacts = artifacts_in_order(tables);
  return text + artifacts + (artifacts.empty() ? "" : "\n");
}

std::string report_published_comparison(const fs::path& database, const fs::path& folder) {
  const Comparison comparison = compare_study(database);
  const std::string table =
      csv_of(published_comparison_table(comparison.tables, comparison.numbers));
  const std::string page = comparison_html(comparison.tables, comparison.numbers);
  make_output_folder(folder);
  write_file(folder / "published_comparison.csv", table);
  write_file(folder / "published_comparison.html", page);
  return comparison_summary(comparison.tables, comparison.numbers) +
         fmt::format("Compared with the published study in {}\n",
                     (folder / "published_comparison.html").string());
}

std::optional<std::vector<std::string>> published_row(
    const StudyTables& tables, std::size_t mark, std::size_t scene,
    const std::vector<std::string>& methods, const std::optional<PublishedStudy>& published) {
  const std::string& own = tables.set.scenes[scene];
  const auto original = published && is_relative_to_od(tables.set)
                            ? published_scene_of(*published, own)
                            : std::nullopt;
  if (!original) {
    return std::nullopt;
  }
  std::vector<std::string> row = {name_of_row(*original, own)};
  for (const std::string& method : methods) {
    row.push_back(mean_and_deviation(
        published_time(*published, original->name, tables.set.measures[mark].id(), method)));
  }
  return row;
}

std::string published_rows_explained(const StudyTables& tables,
                                     const std::optional<PublishedStudy>& published) {
  const bool has_any =
      published && is_relative_to_od(tables.set) &&
      std::any_of(tables.set.scenes.begin(), tables.set.scenes.end(),
                  [&](const auto& scene) { return published_scene_of(*published, scene); });
  return has_any ? " Published: Table 2 of Koskela et al. 2018, section 5.2. A counterpart is "
                   "Foveola’s own scene in a published one’s place."
                 : "";
}

std::vector<std::string> published_mean_and_difference(const MethodTimes& times,
                                                       const PublishedStudy& published) {
  const auto mean = geometric_mean_of_table_2(published, times.mark, times.method);
  if (!mean) {
    return {"–", "–"};
  }
  const bool is_of_seconds = times.method == "od";
  const auto& own = is_of_seconds ? times.seconds : times.percent_of_baseline;
  return {fixed(mean, 1) + (is_of_seconds ? " s" : " %"),
          own ? with_sign(own->value - *mean, 1) + (is_of_seconds ? " s" : " points") : "–"};
}

}  // namespace foveola::analysis
