#include "study/record/recorded_marks.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include "study/record/stored_number.h"

namespace foveola::study {

SQLite::Statement query_of_marks(SQLite::Database& database) {
  return {database,
          "SELECT kind, time_ns, censored FROM mark"
          " WHERE session = ? AND trial = ? AND attempt = ? ORDER BY time_ns"};
}

std::vector<MarkedMoment> read_marks(SQLite::Statement& query, std::int64_t session,
                                     std::size_t trial, int attempt, Nanoseconds first_frame) {
  std::vector<MarkedMoment> marks;
  query.reset();
  SQLite::bind(query, session, static_cast<std::int64_t>(trial), attempt);
  while (query.executeStep()) {
    marks.push_back({query.getColumn(0).getString(), first_frame + time_from(query.getColumn(1)),
                     query.getColumn(2).getInt() == 1});
  }
  return marks;
}

}  // namespace foveola::study
