// A table as a value: its columns, each with its unit and meaning, and its rows. Every file format
// is written from it, and so is the description of the columns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace foveola::analysis {

enum class ColumnType { text, whole, number, truth };

/// "string", "integer", "number", "boolean".
const char* name_of(ColumnType type);

struct Column {
  std::string name;  ///< Ends in the unit where there is one, as mean_s.
  ColumnType type = ColumnType::text;
  std::string unit;         ///< As "s" or "%"; empty if there is none.
  std::string description;  ///< A sentence without its full stop.
};

/// One field of a row; std::monostate is a value that does not exist.
using Field = std::variant<std::monostate, std::string, std::int64_t, double, bool>;
using Row = std::vector<Field>;

/// How a CSV file has texts. Numbers and truth values are the same in both.
enum class CsvTexts {
  guarded,  ///< for people, whose spreadsheet takes no text for a formula: see guarded()
  as_typed  ///< for programs
};

/// Throws Error if a name comes twice, since most readers of a table keep one of such columns.
void require_distinct_names(const std::vector<Column>& columns);

struct Table {
  std::string id;        ///< The name of its file, without extension.
  std::string rows_are;  ///< What there is a row for, as "mark, scene and method".
  std::vector<Column> columns;
  std::vector<Row> rows;
  CsvTexts texts = CsvTexts::guarded;
};

/// A column together with its value in the row of an item.
template <typename Item>
struct ColumnOf {
  Column column;
  std::function<Field(const Item&)> value;
};
template <typename Item>
using ColumnsOf = std::vector<ColumnOf<Item>>;

template <typename Item>
std::vector<Column> columns_in(const ColumnsOf<Item>& columns) {
  std::vector<Column> plain;
  for (const ColumnOf<Item>& column : columns) {
    plain.push_back(column.column);
  }
  return plain;
}

template <typename Item>
Row row_of(const ColumnsOf<Item>& columns, const Item& item) {
  Row row;
  row.reserve(columns.size());
  for (const ColumnOf<Item>& column : columns) {
    row.push_back(column.value(item));
  }
  return row;
}

/// A table with a row for each of `items`, in their order.
template <typename Item>
Table tabulate(std::string id, std::string rows_are, const ColumnsOf<Item>& columns,
               const std::vector<Item>& items) {
  Table table{std::move(id), std::move(rows_are), columns_in(columns), {}};
  for (const Item& item : items) {
    table.rows.push_back(row_of(columns, item));
  }
  return table;
}

// Fields of values that may not exist, and of counts.
inline Field field(const std::optional<double>& value) { return value ? Field(*value) : Field(); }
inline Field field(double value) { return value; }
inline Field field(std::size_t count) { return static_cast<std::int64_t>(count); }
inline Field field(int count) { return static_cast<std::int64_t>(count); }
inline Field field(bool truth) { return truth; }
inline Field field(std::string text) { return text; }

/// `value` of a result that may not exist.
template <typename Result, typename Value>
Field field_in(const std::optional<Result>& result, const Value& value) {
  return result ? field(value(*result)) : Field();
}

}  // namespace foveola::analysis
