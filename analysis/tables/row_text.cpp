#include "analysis/tables/row_text.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "analysis/tables/number_text.h"
#include "analysis/tables/table_formats.h"

namespace foveola::analysis {
namespace {

/// Removes the text before the mark, with the mark, from `rest`; all of it without a mark.
std::string_view cut(std::string_view& rest, char mark) {
  const std::size_t at = rest.find(mark);
  const std::string_view before = rest.substr(0, at);
  rest.remove_prefix(at == std::string_view::npos ? rest.size() : at + 1);
  return before;
}

std::string formatted(double number, std::string_view format) {
  const auto exponential = format.find("exp");
  if (exponential != std::string_view::npos) {
    number = std::exp(number);
  }
  if (const auto sign = format.find_first_of("*/"); sign != std::string_view::npos) {
    const double factor = std::stod(std::string(format.substr(0, sign)));
    number = format[sign] == '*' ? factor * number : factor / number;
  }
  if (format.ends_with('g')) {
    return fmt::format("{:g}", number);
  }
  if (format == "p") {
    return p_value(number);
  }
  const int decimals = format.back() - '0';
  return format.front() == '+' ? with_sign(number, decimals) : fixed(number, decimals);
}

/// Returns the value of a name in braces; empty if it is missing.
std::optional<std::string> value_text(std::string_view braced, const Table& table, const Row& row) {
  std::string_view format = braced;
  std::string_view wanted = cut(format, ':');
  const bool is_condition = wanted.find('=') != std::string_view::npos;
  const std::string_view column = cut(wanted, '=');
  const Field& field = field_in(table, row, column);
  const std::string text = text_of(field);
  if (is_condition) {
    return text == wanted ? std::optional<std::string>("") : std::nullopt;
  }
  if (text.empty() || format.empty()) {
    return text.empty() ? std::nullopt : std::optional(text);
  }
  if (const bool* truth = std::get_if<bool>(&field)) {
    const std::string_view yes = cut(format, '/');
    return std::string(*truth ? yes : format);
  }
  return formatted(number_of(field).value(), format);
}

/// Fills a part of a pattern without "|".
std::optional<std::string> fill_part(std::string_view part, const Table& table, const Row& row) {
  std::string filled(cut(part, '{'));
  while (!part.empty()) {
    const std::optional<std::string> value = value_text(cut(part, '}'), table, row);
    if (!value) {
      return std::nullopt;
    }
    filled += *value;
    filled += cut(part, '{');
  }
  return filled;
}

std::string cell_text(const PrintedColumn& column, const Table& table, const Row& row) {
  for (const std::string& pattern : column.patterns) {
    if (std::optional<std::string> filled = fill(pattern, table, row)) {
      return *std::move(filled);
    }
  }
  return no_value;
}

}  // namespace

const Field& field_in(const Table& table, const Row& row, std::string_view column) {
  const auto found = std::ranges::find(table.columns, column, &Column::name);
  if (found == table.columns.end()) {
    throw std::out_of_range(fmt::format("{} has no column {}", table.id, column));
  }
  return row.at(static_cast<std::size_t>(found - table.columns.begin()));
}

std::optional<double> number_of(const Field& field) {
  if (const auto* whole = std::get_if<std::int64_t>(&field)) {
    return static_cast<double>(*whole);
  }
  const auto* number = std::get_if<double>(&field);
  return number != nullptr ? std::optional(*number) : std::nullopt;
}

std::optional<std::string> fill(std::string_view pattern, const Table& table, const Row& row) {
  std::optional<std::string> filled = fill_part(cut(pattern, '|'), table, row);
  while (filled && !pattern.empty()) {
    *filled += fill_part(cut(pattern, '|'), table, row).value_or("");
  }
  return filled;
}

PrintedTable print_rows(PrintedTable printed, const Table& table, std::string_view where,
                        const std::vector<PrintedColumn>& columns) {
  for (const PrintedColumn& column : columns) {
    printed.columns.push_back(column.heading);
  }
  for (const Row& row : table.rows) {
    if (fill(where, table, row)) {
      std::vector<std::string>& cells = printed.rows.emplace_back();
      for (const PrintedColumn& column : columns) {
        cells.push_back(cell_text(column, table, row));
      }
    }
  }
  return printed;
}

}  // namespace foveola::analysis
