#include "renderer/base/text/csv.h"

#include <algorithm>

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

std::string format_field(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) {
    return field;
  }
  std::string quoted(1, '"');
  for (const char c : field) {
    quoted.append(c == '"' ? 2 : 1, c);
  }
  quoted.push_back('"');
  return quoted;
}

/// Reads fields one by one from the front of a text.
class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& where) : text_(text), where_(where) {}

  bool at_end() const { return text_.empty(); }

  CsvRow row() {
    CsvRow fields;
    do {
      fields.push_back(field());
    } while (skip(","));
    if (!skip("\r\n") && !skip("\n") && !at_end()) {
      fail("has text after a closing quote");
    }
    ++line_;
    return fields;
  }

 private:
  bool skip(std::string_view token) {
    if (!text_.starts_with(token)) {
      return false;
    }
    text_.remove_prefix(token.size());
    return true;
  }

  std::string field() { return skip("\"") ? quoted_field() : plain_field(); }

  std::string plain_field() {
    const std::size_t length = std::min(text_.find_first_of(",\r\n"), text_.size());
    std::string field(text_.substr(0, length));
    text_.remove_prefix(length);
    return field;
  }

  std::string quoted_field() {
    std::string field;
    while (true) {
      const std::size_t quote = text_.find('"');
      if (quote == std::string_view::npos) {
        fail("has an unclosed quote");
      }
      field += text_.substr(0, quote);
      text_.remove_prefix(quote + 1);
      if (!skip("\"")) {
        return field;
      }
      field += '"';
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(fmt::format("{}:{}", where_, line_), what,
                "double each quote within a quoted field, and close the field (RFC 4180)");
  }

  std::string_view text_;
  const std::string& where_;
  int line_ = 1;
};

}  // namespace

std::string format_csv(const std::vector<CsvRow>& rows) {
  std::string text;
  for (const CsvRow& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += i > 0 ? "," : "";
      text += format_field(row[i]);
    }
    text += "\r\n";
  }
  return text;
}

std::vector<CsvRow> parse_csv(std::string_view text, const std::string& where) {
  CsvReader reader(text, where);
  std::vector<CsvRow> rows;
  while (!reader.at_end()) {
    rows.push_back(reader.row());
  }
  return rows;
}

std::string csv_number(std::optional<double> value) {
  return value ? fmt::format("{}", *value) : std::string();
}

}  // namespace foveola
