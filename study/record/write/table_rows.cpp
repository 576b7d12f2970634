#include "study/record/write/table_rows.h"

#include <algorithm>
#include <span>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "renderer/base/files/digest.h"

namespace foveola::study {
namespace {

std::vector<std::string> replaced(std::vector<std::string> columns,
                                  const Replacements& replacements) {
  for (std::string& column : columns) {
    const auto found = replacements.find(column);
    column = found == replacements.end() ? column : found->second;
  }
  return columns;
}

/// Binds a value of a row as it is.
void bind_as_it_is(SQLite::Statement& statement, int index, const SQLite::Column& value) {
  if (value.isInteger()) {
    statement.bind(index, value.getInt64());
  } else if (value.isFloat()) {
    statement.bind(index, value.getDouble());
  } else if (value.isText()) {
    statement.bind(index, value.getString());
  } else if (value.isBlob()) {
    statement.bind(index, value.getBlob(), value.getBytes());
  }
}

/// Whoever reads them must know how many: by the value's type, or by a length before them.
void append_bytes(std::string& bytes, const void* data, std::size_t size) {
  bytes.append(static_cast<const char*>(data), size);
}

void append_value(std::string& bytes, const SQLite::Column& value) {
  bytes += static_cast<char>(value.getType());
  if (value.isInteger()) {
    const std::int64_t integer = value.getInt64();
    append_bytes(bytes, &integer, sizeof integer);
  } else if (value.isFloat()) {
    const double real = value.getDouble();
    append_bytes(bytes, &real, sizeof real);
  } else if (!value.isNull()) {
    const void* data = value.getBlob();  // of a text, its bytes
    const auto size = static_cast<std::size_t>(value.getBytes());
    append_bytes(bytes, &size, sizeof size);
    append_bytes(bytes, data, size);
  }
}

}  // namespace

std::vector<std::string> columns_of(SQLite::Database& database, const std::string& table) {
  std::vector<std::string> columns;
  SQLite::Statement rows(database, "SELECT name FROM pragma_table_info(?) ORDER BY cid");
  rows.bind(1, table);
  while (rows.executeStep()) {
    columns.push_back(rows.getColumn(0).getString());
  }
  return columns;
}

void copy_rows(SQLite::Database& source, SQLite::Database& target, const std::string& table,
               const std::string& condition, const Replacements& replacements) {
  const std::vector<std::string> columns = columns_of(source, table);
  SQLite::Statement rows(
      source, fmt::format("SELECT {} FROM {} WHERE {} ORDER BY rowid",
                          fmt::join(replaced(columns, replacements), ", "), table, condition));
  const std::vector<std::string> places(columns.size(), "?");
  SQLite::Statement insert(target, fmt::format("INSERT INTO {} ({}) VALUES ({})", table,
                                               fmt::join(columns, ", "), fmt::join(places, ", ")));
  while (rows.executeStep()) {
    insert.reset();
    insert.clearBindings();
    for (int i = 0; i < rows.getColumnCount(); ++i) {
      bind_as_it_is(insert, i + 1, rows.getColumn(i));
    }
    insert.exec();
  }
}

std::vector<std::string> sorted_rows(SQLite::Statement& rows,
                                     const std::set<std::string>& ignored) {
  std::vector<int> columns;
  for (int i = 0; i < rows.getColumnCount(); ++i) {
    if (!ignored.contains(rows.getColumnName(i))) {
      columns.push_back(i);
    }
  }
  std::vector<std::string> sorted;
  while (rows.executeStep()) {
    std::string bytes;
    for (const int column : columns) {
      append_value(bytes, rows.getColumn(column));
    }
    sorted.push_back(std::move(bytes));
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

std::string digest_of_rows(SQLite::Database& database, const std::string& table,
                           const std::string& condition, const std::set<std::string>& ignored) {
  SQLite::Statement rows(database, fmt::format("SELECT * FROM {} WHERE {}", table, condition));
  Sha256 digest;
  for (const std::string& row : sorted_rows(rows, ignored)) {
    const std::size_t size = row.size();
    digest.update(std::as_bytes(std::span(&size, 1)));
    digest.update(std::as_bytes(std::span(row)));
  }
  return digest.hex();
}

std::string is_of_session(std::int64_t session) { return fmt::format("session = {}", session); }

}  // namespace foveola::study
