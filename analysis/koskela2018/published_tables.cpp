#include "analysis/koskela2018/published_tables.h"

#include <charconv>

#include <fmt/format.h>

#include "renderer/base/csv.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace fs = std::filesystem;

namespace foveola::analysis {
namespace {

struct TableRow {
  CsvRow fields;
  std::string where;  ///< file:line
};

std::vector<TableRow> rows_with_columns(const fs::path& path, const CsvRow& columns) {
  const std::vector<CsvRow> rows = parse_csv(read_file(path), path.string());
  if (rows.empty() || rows.front() != columns) {
    throw Error(path.string() + ":1",
                fmt::format("does not have the columns {}", fmt::join(columns, ",")),
                "restore the file");
  }
  std::vector<TableRow> result;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::string where = fmt::format("{}:{}", path.string(), i + 1);
    if (rows[i].size() != columns.size()) {
      throw Error(where, fmt::format("has {} fields instead of {}", rows[i].size(), columns.size()),
                  "restore the file");
    }
    result.push_back({rows[i], where});
  }
  return result;
}

std::optional<double> number_at_hand(const TableRow& row, std::size_t column) {
  const std::string& field = row.fields[column];
  if (field.empty()) {
    return std::nullopt;
  }
  double value = 0.0;
  const char* end = field.data() + field.size();
  const auto [stop, failure] = std::from_chars(field.data(), end, value);
  if (failure != std::errc() || stop != end) {
    throw Error(row.where, fmt::format("\"{}\" is not a number", field), "restore the file");
  }
  return value;
}

const std::string& published_mark(const TableRow& row, std::size_t column) {
  const std::string& mark = row.fields[column];
  if (mark != "outline" && mark != "material") {
    throw Error(row.where, fmt::format("\"{}\" is not a mark", mark), "restore the file");
  }
  return mark;
}

}  // namespace

PublishedTables read_published_tables(const fs::path& folder) {
  PublishedTables tables;
  for (const TableRow& row : rows_with_columns(folder / "table1.csv", {"question", "mean", "sd"})) {
    tables.background.push_back({row.fields[0], number_at_hand(row, 1), number_at_hand(row, 2)});
  }
  for (const TableRow& row : rows_with_columns(
           folder / "table2.csv", {"scene", "counterpart", "mark", "method", "mean", "sd"})) {
    tables.times.push_back({row.fields[0], row.fields[1], published_mark(row, 2), row.fields[3],
                            number_at_hand(row, 4), number_at_hand(row, 5)});
  }
  return tables;
}

}  // namespace foveola::analysis
