#include "analysis/koskela2018/published_study.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "analysis/koskela2018/profile.h"
#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/text/csv.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

constexpr const char* remedy = "install Foveola again";

struct TableRow {
  CsvRow fields;
  std::string where;  ///< file:line
};

std::vector<TableRow> rows_with_columns(const fs::path& path, const CsvRow& columns) {
  const std::vector<CsvRow> rows = parse_csv(read_file(path), path.string());
  if (rows.empty() || rows.front() != columns) {
    throw Error(path.string() + ":1",
                fmt::format("does not have the columns {}", fmt::join(columns, ",")), remedy);
  }
  std::vector<TableRow> result;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::string where = fmt::format("{}:{}", path.string(), i + 1);
    if (rows[i].size() != columns.size()) {
      throw Error(where, fmt::format("has {} fields instead of {}", rows[i].size(), columns.size()),
                  remedy);
    }
    result.push_back({rows[i], where});
  }
  return result;
}

double number(const TableRow& row, std::size_t column) {
  const std::string& field = row.fields[column];
  double value = 0.0;
  const char* end = field.data() + field.size();
  const auto [stop, failure] = std::from_chars(field.data(), end, value);
  if (failure != std::errc() || stop != end) {
    throw Error(row.where, fmt::format("\"{}\" is not a number", field), remedy);
  }
  return value;
}

const std::string& published_mark(const TableRow& row, std::size_t column) {
  const std::string& mark = row.fields[column];
  if (mark != "outline" && mark != "material") {
    throw Error(row.where, fmt::format("\"{}\" is not a mark", mark), remedy);
  }
  return mark;
}

}  // namespace

PublishedStudy read_published_study(const fs::path& folder) {
  PublishedStudy published{.folder = folder};
  for (const TableRow& row : rows_with_columns(folder / "table1.csv", {"question", "mean", "sd"})) {
    published.background.push_back({row.fields[0], number(row, 1), number(row, 2)});
  }
  for (const TableRow& row : rows_with_columns(
           folder / "table2.csv", {"scene", "counterpart", "mark", "method", "mean", "sd"})) {
    published.times.push_back({row.fields[0], row.fields[1], published_mark(row, 2), row.fields[3],
                               number(row, 4), number(row, 5)});
  }
  for (const TableRow& row :
       rows_with_columns(folder / "text.csv", {"figure", "value", "unit", "section"})) {
    published.text.push_back({row.fields[0], number(row, 1), row.fields[2], row.fields[3]});
  }
  return published;
}

std::optional<PublishedStudy> published_study_for(const Dataset& set) {
  return measures_what_was_published(set)
             ? std::optional(read_published_study(resource_folder() / "data" / "koskela2018"))
             : std::nullopt;
}

const PublishedNumber& published_number(const PublishedStudy& published, const std::string& id) {
  const auto found = std::ranges::find(published.text, id, &PublishedNumber::id);
  if (found == published.text.end()) {
    throw Error((published.folder / "text.csv").string(),
                fmt::format("has no row of the figure \"{}\"", id), remedy);
  }
  return *found;
}

const PublishedAnswers* published_answers(const PublishedStudy& published,
                                          const std::string& question) {
  const auto found = std::ranges::find(published.background, question, &PublishedAnswers::question);
  return found == published.background.end() ? nullptr : &*found;
}

const PublishedTime* published_time(const PublishedStudy& published, const std::string& scene,
                                    const std::string& mark, const std::string& method) {
  const auto found = std::ranges::find_if(published.times, [&](const PublishedTime& time) {
    return time.scene == scene && time.mark == mark && time.method == method;
  });
  return found == published.times.end() ? nullptr : &*found;
}

Estimate published_mean(const PublishedStudy& published, double mean, double standard_deviation) {
  const auto n = static_cast<std::size_t>(published_number(published, "participants").value);
  return mean_estimate(Description{.n = n, .mean = mean, .standard_deviation = standard_deviation})
      .value();
}

std::optional<double> geometric_mean_of_table_2(const PublishedStudy& published,
                                                const std::string& mark,
                                                const std::string& method) {
  std::vector<double> means;
  for (const PublishedTime& time : published.times) {
    if (time.mark == mark && time.method == method) {
      means.push_back(time.mean);
    }
  }
  const std::optional<Estimate> estimate = geometric_mean(means);
  return estimate ? std::optional(estimate->value) : std::nullopt;
}

std::optional<PublishedScene> published_scene_of(const PublishedStudy& published,
                                                 const std::string& scene) {
  for (const PublishedTime& time : published.times) {
    if (scene == time.scene || scene == time.counterpart) {
      return PublishedScene{time.scene, scene != time.scene};
    }
  }
  return std::nullopt;
}

}  // namespace foveola::analysis
