// A table as a value: columns with unit and meaning, and rows. Every file format, and the
// description of the columns, is written from it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "renderer/base/transformed.h"

namespace foveola::analysis {

enum class ColumnType { text, whole, number, truth };

/// Returns "string", "integer", "number" or "boolean".
const char* name_of(ColumnType type);

struct Column {
  std::string name;  ///< Ends in the unit if there is one, as mean_s.
  ColumnType type = ColumnType::text;
  std::string unit;         ///< As "s" or "%"; empty if there is none.
  std::string description;  ///< A sentence without its full stop.
};

/// One field of a row; std::monostate is a missing value.
using Field = std::variant<std::monostate, std::string, std::int64_t, double, bool>;
using Row = std::vector<Field>;

/// Texts in CSV. Numbers and truth values do not differ.
enum class CsvTexts {
  guarded,  ///< for people: no spreadsheet takes a text for a formula, see guarded()
  as_typed  ///< for programs
};

/// Throws Error if a name is repeated, since most readers of a table keep only one of such columns.
void require_distinct_names(const std::vector<Column>& columns);

struct Table {
  std::string id;        ///< The name of its file, without extension.
  std::string rows_are;  ///< Description of a row, as "mark, scene and method".
  std::vector<Column> columns;
  std::vector<Row> rows;
  CsvTexts texts = CsvTexts::guarded;
};

/// Whether a type is std::optional of a value's type.
template <typename Type>
struct IsOptional : std::false_type {};
template <typename Value>
struct IsOptional<std::optional<Value>> : std::true_type {};
template <typename Type>
inline constexpr bool is_optional = IsOptional<Type>::value;

/// Returns the field of a value that may be missing: of a truth value, a number, an enumerator by
/// its name_of, or a text.
template <typename Value>
Field field(const Value& value) {
  if constexpr (is_optional<Value>) {
    return value ? field(*value) : Field();
  } else if constexpr (std::is_same_v<Value, bool> || std::is_same_v<Value, Field>) {
    return value;
  } else if constexpr (std::is_floating_point_v<Value>) {
    return static_cast<double>(value);
  } else if constexpr (std::is_integral_v<Value>) {
    return static_cast<std::int64_t>(value);
  } else if constexpr (std::is_enum_v<Value>) {
    return std::string(name_of(value));
  } else {
    return std::string(value);
  }
}

template <typename Value>
constexpr ColumnType column_type() {
  if constexpr (is_optional<Value>) {
    return column_type<typename Value::value_type>();
  } else if constexpr (std::is_same_v<Value, bool>) {
    return ColumnType::truth;
  } else if constexpr (std::is_arithmetic_v<Value>) {
    return std::is_integral_v<Value> ? ColumnType::whole : ColumnType::number;
  } else {
    return ColumnType::text;
  }
}

/// Returns the value at the end of `steps`, each a member or a function of the previous value:
/// follow(row, &MethodComparison::ratio, &RatioTest::ratio). Empty if one on the way is empty or
/// null.
template <typename From, typename Step, typename... Steps>
auto follow(const From& from, const Step& step, const Steps&... steps) {
  if constexpr (is_optional<From> || std::is_pointer_v<From>) {
    using Found = decltype(follow(*from, step, steps...));
    using Result = std::conditional_t<is_optional<Found>, Found, std::optional<Found>>;
    return from ? Result(follow(*from, step, steps...)) : Result();
  } else if constexpr (sizeof...(Steps) == 0) {
    return std::invoke(step, from);
  } else {
    return follow(std::invoke(step, from), steps...);
  }
}

/// Returns a function of an item that follows these steps.
template <typename... Steps>
auto path(Steps... steps) {
  return [=](const auto& item) { return follow(item, steps...); };
}

/// Converts a fraction to per cent: a step of a path.
inline double in_percent(double share) { return 100.0 * share; }

/// A column together with its value in an item's row.
template <typename Item>
struct ColumnOf {
  Column column;
  std::function<Field(const Item&)> value;

  /// `value` is a member, a path or another function of an item.
  template <typename Value>
  ColumnOf(Column described, Value of_item)
      : column(std::move(described)), value([of_item = std::move(of_item)](const Item& item) {
          return field(std::invoke(of_item, item));
        }) {}
  /// The column's type is that of `value`.
  template <typename Value>
  ColumnOf(std::string name, std::string unit, std::string description, Value value)
      : ColumnOf({std::move(name),
                  column_type<std::remove_cvref_t<std::invoke_result_t<Value, const Item&>>>(),
                  std::move(unit), std::move(description)},
                 std::move(value)) {}
};
template <typename Item>
using ColumnsOf = std::vector<ColumnOf<Item>>;

template <typename Item>
std::vector<Column> columns_in(const ColumnsOf<Item>& columns) {
  return transformed(columns, &ColumnOf<Item>::column);
}

template <typename Item>
Row row_of(const ColumnsOf<Item>& columns, const Item& item) {
  return transformed(columns, [&](const ColumnOf<Item>& column) { return column.value(item); });
}

/// Returns a table with a row for each of `items`, in their order.
template <typename Item>
Table tabulate(std::string id, std::string rows_are, const ColumnsOf<Item>& columns,
               const std::vector<Item>& items) {
  Table table{std::move(id), std::move(rows_are), columns_in(columns), {}};
  for (const Item& item : items) {
    table.rows.push_back(row_of(columns, item));
  }
  return table;
}

}  // namespace foveola::analysis
