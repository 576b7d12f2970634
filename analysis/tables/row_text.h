// Formats a table's rows as texts.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/tables/printed_table.h"
#include "analysis/tables/table.h"

namespace foveola::analysis {

/// Returns the field in the column of this name. Throws std::out_of_range if the table has no such
/// column.
const Field& field_in(const Table& table, const Row& row, std::string_view column);

/// Returns a number, whole or not; empty for any other field.
std::optional<double> number_of(const Field& field);

/// Returns the pattern with the row's values in place of their columns' names in braces:
///   {n}               as in a CSV file
///   {t:.2} {t:+.2}    with two decimals; with its sign
///   {df:g} {p:p}      as short as can be; as a P-value
///   {x:100*.1}        times a factor
///   {x:1/.1}          a factor over the value
///   {x:100*exp.1}     of the value's exponential
///   {exact:yes/no}    one of two words for a truth value
///   {scale=ratio}     nothing; as if it were missing unless the text is equal
/// Text after a "|" is left out, up to the next one, if a value in it is missing. Empty if a value
/// before the first "|" is missing. An empty text counts as missing.
std::optional<std::string> fill(std::string_view pattern, const Table& table, const Row& row);

struct PrintedColumn {
  std::string heading;
  std::vector<std::string> patterns;  ///< Of fill(); the first that can be filled is used.

  PrintedColumn(std::string name, std::vector<std::string> of_cells)
      : heading(std::move(name)), patterns(std::move(of_cells)) {}
  template <std::convertible_to<std::string>... Patterns>
  PrintedColumn(std::string name, Patterns... of_cells)
      : heading(std::move(name)), patterns{std::move(of_cells)...} {}
};

/// Adds the columns and, for each row of `table` for which `where` can be filled, the texts of its
/// cells; no_value if no pattern can be filled.
PrintedTable print_rows(PrintedTable printed, const Table& table, std::string_view where,
                        const std::vector<PrintedColumn>& columns);

}  // namespace foveola::analysis
