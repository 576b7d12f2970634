#include "analysis/publication/summary.h"

#include <algorithm>

#include <fmt/format.h>

#include "analysis/publication/wording.h"

namespace foveola::analysis {
namespace {

using TextRow = std::vector<std::string>;

std::string printable(const std::string& name) {
  std::string text = name;
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return text;
}

/// The number of characters of UTF-8 text.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

/// Aligns the first column to the left, the others to the right.
std::string aligned(const std::vector<TextRow>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const TextRow& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], width_of(row[i]));
    }
  }
  std::string text;
  for (const TextRow& row : rows) {
    text += fmt::format("  {:<{}}", row[0], widths[0]);
    for (std::size_t i = 1; i < row.size(); ++i) {
      text += fmt::format("   {:>{}}", row[i], widths[i]);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

/// The end of a table's title, which says whose data it shows.
std::string notice(const StudyTables& tables) {
  const std::string text = data_notice(tables);
  return text.empty() ? "" : fmt::format(" ({})", text);
}

TextRow heading_row(const StudyTables& tables) {
  TextRow row = {"scene"};
  for (std::size_t method = 0; method < tables.set.methods.size(); ++method) {
    row.push_back(printable(method_label(tables.set.methods[method])) +
                  (method == baseline ? ", s" : ", %"));
  }
  row.emplace_back("censored");
  return row;
}

TextRow scene_row(const StudyTables& tables, Mark mark, std::size_t scene) {
  TextRow row = {printable(tables.set.scenes[scene])};
  int censored = 0;
  for (std::size_t method = 0; method < tables.set.methods.size(); ++method) {
    const SceneTimes& times = tables.scene_times_of(mark, scene, method);
    row.push_back(method == baseline ? mean_and_deviation(times.seconds, 2)
                                     : mean_and_deviation(times.percent_of_baseline, 1));
    censored += times.censored;
  }
  row.push_back(std::to_string(censored));
  return row;
}

TextRow overall_row(const StudyTables& tables, Mark mark) {
  TextRow row = {"geometric mean"};
  for (std::size_t method = 0; method < tables.set.methods.size(); ++method) {
    const MethodTimes& times = tables.method_times_of(mark, method);
    row.push_back(method == baseline ? with_interval(times.seconds, 2)
                                     : with_interval(times.percent_of_baseline, 1));
  }
  row.emplace_back("");
  return row;
}

std::string times_block(const StudyTables& tables, Mark mark) {
  std::vector<TextRow> rows = {heading_row(tables)};
  for (std::size_t scene = 0; scene < tables.set.scenes.size(); ++scene) {
    rows.push_back(scene_row(tables, mark, scene));
  }
  rows.push_back(overall_row(tables, mark));
  return fmt::format("Time until the {} was visible{}\n{}", name_of(mark), notice(tables),
                     aligned(rows));
}

std::string ratings_block(const StudyTables& tables) {
  std::vector<TextRow> rows = {{"method", "mean ± sd", "median", "1 / 2 / 3 / 4 / 5"}};
  for (const MethodRatings& ratings : tables.ratings) {
    rows.push_back({printable(method_label(ratings.method)), mean_and_deviation(ratings.rating, 2),
                    fixed(ratings.rating.median, 1),
                    fmt::format("{}", fmt::join(ratings.counts, " / "))});
  }
  const RatingScale& scale = tables.set.rating_scale;
  const std::string notes = notes_on(scale);
  return fmt::format("Artifacts in other areas, {}{}\n{}{}", printable(points_in_words(scale)),
                     notice(tables), aligned(rows),
                     notes.empty() ? "" : fmt::format(" {}\n", printable(notes)));
}

std::string background_block(const StudyTables& tables) {
  std::vector<TextRow> rows = {{"seconds saved", "n", "r", "P"}};
  for (const BackgroundCorrelation& row : tables.background_correlations) {
    rows.push_back(
        {fmt::format("{} − {}, {}", printable(method_label(tables.set.methods[baseline])),
                     printable(method_label(row.method)), name_of(row.mark)),
         std::to_string(row.participants), row.pearson ? fixed(row.pearson->r, 2) : "–",
         row.pearson ? p_value(row.pearson->p) : "–"});
  }
  return fmt::format("Background ({}) against speed-up{}\n{}",
                     printable(listed(tables.background.questions)), notice(tables), aligned(rows));
}

}  // namespace

std::string terminal_summary(const StudyTables& tables) {
  std::string text = fmt::format(
      "{}: {}, {}, {}\n", printable(tables.protocol_name), participants_in_words(tables),
      counted(tables.set.scenes.size(), "scene"), counted(tables.set.methods.size(), "method"));
  for (const Mark mark : marks) {
    text += fmt::format("\n{}", times_block(tables, mark));
  }
  text += fmt::format(
      "  Mean ± standard deviation; % of each participant's own {} time. The last row: geometric\n"
      "  mean over scenes with a 95 % interval over participants.\n",
      printable(method_label(tables.set.methods[baseline])));
  text += fmt::format("\n{}", ratings_block(tables));
  if (!tables.background_correlations.empty() && !tables.background.questions.empty()) {
    text += fmt::format("\n{}", background_block(tables));
  }
  return text;
}

}  // namespace foveola::analysis
