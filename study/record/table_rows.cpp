#include "study/record/table_rows.h"

#include <span>
#include <vector>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "renderer/base/digest.h"

namespace foveola::study {
namespace {

std::vector<std::string> columns_of(SQLite::Database& database, const std::string& table) {
  std::vector<std::string> columns;
  SQLite::Statement rows(database, "SELECT name FROM pragma_table_info(?) ORDER BY cid");
  rows.bind(1, table);
  while (rows.executeStep()) {
    columns.push_back(rows.getColumn(0).getString());
  }
  return columns;
}

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

}  // namespace

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

std::string digest_of_rows(SQLite::Database& database, const std::string& table,
                           const std::string& condition, const Replacements& replacements) {
  std::string values;
  for (const std::string& column : replaced(columns_of(database, table), replacements)) {
    values += fmt::format("{}quote({})", values.empty() ? "" : " || ',' || ", column);
  }
  SQLite::Statement rows(
      database, fmt::format("SELECT {} FROM {} WHERE {} ORDER BY 1", values, table, condition));
  Sha256 digest;
  while (rows.executeStep()) {
    // Values are quoted, so that where one row ends is not in doubt.
    const std::string row = rows.getColumn(0).getString() + '\n';
    digest.update(std::as_bytes(std::span(row)));
  }
  return digest.hex();
}

std::string is_of_session(std::int64_t session) { return fmt::format("session = {}", session); }

}  // namespace foveola::study
