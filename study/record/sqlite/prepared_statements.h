// SQL that is asked for again and again, compiled once for a connection: compiling takes longer
// than running it does.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

namespace foveola::study {

/// The statements of a connection, which must outlive them, each kept once it was asked for.
class PreparedStatements {
 public:
  explicit PreparedStatements(SQLite::Database& database) : database_(database) {}

  SQLite::Database& database() { return database_; }
  /// The statement of this text. Throws what SQLite throws.
  SQLite::Statement& find(const std::string& sql);

 private:
  SQLite::Database& database_;
  std::map<std::string, SQLite::Statement> statements_;
};

/// One use of a statement: as new when it begins, and no longer in the way of other connections
/// when it ends. No two uses of one text may overlap.
class PreparedStatement {
 public:
  PreparedStatement(PreparedStatements& statements, const std::string& sql)
      : statement_(statements.find(sql)) {}
  /// With its first parameter bound.
  PreparedStatement(PreparedStatements& statements, const std::string& sql, std::int64_t first)
      : PreparedStatement(statements, sql) {
    statement_.bind(1, first);
  }
  ~PreparedStatement();
  PreparedStatement(const PreparedStatement&) = delete;
  PreparedStatement& operator=(const PreparedStatement&) = delete;

  SQLite::Statement& operator*() { return statement_; }
  SQLite::Statement* operator->() { return &statement_; }

 private:
  SQLite::Statement& statement_;
};

}  // namespace foveola::study
