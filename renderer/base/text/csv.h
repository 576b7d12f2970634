// Writes and reads comma-separated values after RFC 4180.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foveola {

using CsvRow = std::vector<std::string>;

/// Rows as text with CRLF line ends; fields with commas, quotes or line breaks are quoted.
std::string format_csv(const std::vector<CsvRow>& rows);

/// Reads what format_csv writes; LF line ends are accepted too. `where` names the source in errors.
/// Throws Error for an unfinished quote, or for text after a closing quote.
std::vector<CsvRow> parse_csv(std::string_view text, const std::string& where);

/// The shortest text that reads back as the same number; an absent value gives empty text.
std::string csv_number(std::optional<double> value);

}  // namespace foveola
