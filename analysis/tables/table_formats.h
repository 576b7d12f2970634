// Writes tables as CSV, TSV and JSON, and descriptions of their columns. Functions that write
// column names throw as require_distinct_names.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "analysis/tables/table.h"

namespace foveola::analysis {

/// Returns the shortest text that reads back as the same value, as in CSV; empty if it is missing.
std::string text_of(const Field& field);

/// Returns the text, with an apostrophe before it if it begins with one, or with a spreadsheet's
/// beginning of a formula (https://owasp.org/www-community/attacks/CSV_Injection). A text that
/// begins with an apostrophe is, without it, the original text.
std::string guarded(const std::string& text);

/// Return the heading, or a row, as a line of CSV (RFC 4180). Truth values are TRUE and FALSE.
std::string csv_heading(const std::vector<Column>& columns);
std::string csv_row(const Row& row, CsvTexts texts = CsvTexts::as_typed);
std::string csv_of(const Table& table);

/// Return the heading, or a row, as a line of BIDS's tab-separated values: without quotes, tabs and
/// line breaks as spaces, "n/a" for missing values, true and false.
std::string tsv_heading(const std::vector<Column>& columns);
std::string tsv_row(const Row& row);

/// Returns an object per row, with null for missing values.
nlohmann::ordered_json json_of(const Table& table);

/// Returns a row per column of each table: file, variable, type, unit, description, whether the
/// file's texts are guarded.
Table codebook_of(const std::vector<Table>& tables);

/// Returns the tables' columns in Markdown, one list per file.
std::string columns_in_markdown(const std::vector<Table>& tables);

}  // namespace foveola::analysis
