#include "analysis/tables/table_formats.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "renderer/base/text/csv.h"
#include "renderer/base/transformed.h"

namespace foveola::analysis {
namespace {

struct TruthWords {
  const char* yes;
  const char* no;
};

// R reads only upper case as truth values by default, and pandas reads both. BIDS needs lower case,
// like JSON.
constexpr TruthWords in_csv{"TRUE", "FALSE"};
constexpr TruthWords in_tsv{"true", "false"};

/// Names the alternative of a field, for std::visit.
struct TextOf {
  TruthWords truth_words;
  CsvTexts texts = CsvTexts::as_typed;
  std::string operator()(std::monostate /*missing*/) const { return ""; }
  std::string operator()(const std::string& text) const {
    return texts == CsvTexts::guarded ? guarded(text) : text;
  }
  std::string operator()(std::int64_t whole) const { return std::to_string(whole); }
  std::string operator()(double number) const { return csv_number(number); }
  std::string operator()(bool truth) const { return truth ? truth_words.yes : truth_words.no; }
};

struct JsonOf {
  nlohmann::ordered_json operator()(std::monostate /*missing*/) const { return nullptr; }
  template <typename Value>
  nlohmann::ordered_json operator()(const Value& value) const {
    return value;
  }
};

CsvRow texts_of(const Row& row, const TextOf& text_of_field) {
  return transformed(row, [&](const Field& field) { return std::visit(text_of_field, field); });
}

CsvRow names_of(const std::vector<Column>& columns) {
  require_distinct_names(columns);
  return transformed(columns, &Column::name);
}

/// Returns "n/a" for a missing value. A typed "n/a" gets an apostrophe before it, and so does one
/// with apostrophes already, so that one can be removed again.
std::string in_bids(const std::string& text) {
  if (text.empty()) {
    return "n/a";
  }
  const std::size_t quoted = text.find_first_not_of('\'');
  return quoted != std::string::npos && text.substr(quoted) == "n/a" ? "'" + text : text;
}

std::string tsv_line(const CsvRow& texts) {
  std::string line;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    std::string text = in_bids(texts[i]);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
    line += (i > 0 ? "\t" : "") + text;
  }
  return line + "\n";
}

}  // namespace

std::string text_of(const Field& field) { return std::visit(TextOf{in_csv}, field); }

std::string csv_heading(const std::vector<Column>& columns) {
  return format_csv({names_of(columns)});
}

std::string guarded(const std::string& text) {
  // As on keyboards, and in the full width of East Asian ones.
  constexpr std::array<std::string_view, 12> beginnings{
      "'", "=", "+", "-", "@", "\t", "\r", "\n", "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"};
  const bool is_risky = std::ranges::any_of(
      beginnings, [&](std::string_view beginning) { return text.starts_with(beginning); });
  return is_risky ? "'" + text : text;
}

std::string csv_row(const Row& row, CsvTexts texts) {
  return format_csv({texts_of(row, {in_csv, texts})});
}

std::string csv_of(const Table& table) {
  std::string text = csv_heading(table.columns);
  for (const Row& row : table.rows) {
    text += csv_row(row, table.texts);
  }
  return text;
}

std::string tsv_heading(const std::vector<Column>& columns) { return tsv_line(names_of(columns)); }

std::string tsv_row(const Row& row) { return tsv_line(texts_of(row, {in_tsv})); }

nlohmann::ordered_json json_of(const Table& table) {
  require_distinct_names(table.columns);
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Row& row : table.rows) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < row.size(); ++i) {
      object[table.columns[i].name] = std::visit(JsonOf(), row[i]);
    }
    rows.push_back(std::move(object));
  }
  return rows;
}

Table codebook_of(const std::vector<Table>& tables) {
  Table codebook{"codebook",
                 "column of each file",
                 {{"file", ColumnType::text, "", "Name of the file, without its extension"},
                  {"variable", ColumnType::text, "", "Name of the column"},
                  {"type", ColumnType::text, "", "string, integer, number or boolean"},
                  {"unit", ColumnType::text, "", "Unit of the values, if they have one"},
                  {"description", ColumnType::text, "", "Description of the values"},
                  {"guarded", ColumnType::truth, "",
                   "Whether texts in the file have an apostrophe before what a spreadsheet takes "
                   "for the beginning of a formula, and before an apostrophe"}},
                 {}};
  for (const Table& table : tables) {
    for (const Column& column : table.columns) {
      codebook.rows.push_back({table.id, column.name, std::string(name_of(column.type)),
                               column.unit, column.description, table.texts == CsvTexts::guarded});
    }
  }
  return codebook;
}

std::string columns_in_markdown(const std::vector<Table>& tables) {
  std::string text;
  for (const Table& table : tables) {
    text += fmt::format("### {}.csv\n\nA row for each {}.\n\n", table.id, table.rows_are);
    for (const Column& column : table.columns) {
      text += fmt::format("- `{}` ({}{}{}): {}.\n", column.name, name_of(column.type),
                          column.unit.empty() ? "" : ", ", column.unit, column.description);
    }
    text += "\n";
  }
  return text;
}

}  // namespace foveola::analysis
