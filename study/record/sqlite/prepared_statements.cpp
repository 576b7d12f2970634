#include "study/record/sqlite/prepared_statements.h"

namespace foveola::study {

SQLite::Statement& PreparedStatements::find(const std::string& sql) {
  const auto found = statements_.find(sql);
  return found != statements_.end() ? found->second
                                    : statements_.try_emplace(sql, database_, sql).first->second;
}

PreparedStatement::~PreparedStatement() {
  statement_.tryReset();
  statement_.clearBindings();
}

}  // namespace foveola::study
