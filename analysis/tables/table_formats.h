// Tables as files for other programs: CSV, TSV and JSON, and descriptions of their columns.
// Whatever writes names of columns throws what require_distinct_names does.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "analysis/tables/table.h"

namespace foveola::analysis {

/// The shortest text that reads back as the same value, as in CSV; empty where there is none.
std::string text_of(const Field& field);

/// The text with an apostrophe before it if it begins with one, or with what a spreadsheet takes
/// for the beginning of a formula (https://owasp.org/www-community/attacks/CSV_Injection). Without
/// its first apostrophe, a text that begins with one is the text that it was.
std::string guarded(const std::string& text);

/// The heading, or a row, as a line of CSV (RFC 4180). Truth values are TRUE and FALSE.
std::string csv_heading(const std::vector<Column>& columns);
std::string csv_row(const Row& row, CsvTexts texts = CsvTexts::as_typed);
std::string csv_of(const Table& table);

/// The heading, or a row, as a line of tab-separated values as BIDS has them: without quotes, tabs
/// and line breaks as spaces, "n/a" for what is missing, true and false.
std::string tsv_heading(const std::vector<Column>& columns);
std::string tsv_row(const Row& row);

/// An object for each row, with null for what is missing.
nlohmann::ordered_json json_of(const Table& table);

/// A row for each column of each table: file, variable, type, unit, description, whether the file's
/// texts are guarded.
Table codebook_of(const std::vector<Table>& tables);

/// The tables' columns in Markdown, one list for each file.
std::string columns_in_markdown(const std::vector<Table>& tables);

}  // namespace foveola::analysis
