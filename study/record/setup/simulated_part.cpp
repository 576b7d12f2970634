#include "study/record/setup/simulated_part.h"

#include <cstddef>
#include <set>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include "study/design/participant_code.h"
#include "study/record/sqlite/stored_number.h"

namespace foveola::study {

std::optional<ShardedStudy> read_sharded_study(SQLite::Database& study) {
  if (!study.tableExists("simulated_part")) {
    return std::nullopt;
  }
  constexpr std::size_t max_participants = 1'000'000;
  SQLite::Statement row(study, "SELECT seed, participants FROM simulated_part");
  if (!row.executeStep()) {
    return std::nullopt;
  }
  return ShardedStudy{.seed = row.getColumn(0).getString(),
                      .participants = place_in<int>(row.getColumn(1), max_participants + 1)};
}

std::optional<std::string> part_fault(SQLite::Database& study) {
  if (!study.tableExists("simulated_part") ||
      study.execAndGet("SELECT count(*) = 1 AND min(seed NOT GLOB '*[^0-9]*')"
                       " AND (NOT EXISTS (SELECT 1 FROM session) OR EXISTS"
                       "  (SELECT 1 FROM session JOIN simulated_part USING (seed)"
                       "   WHERE kind = 'simulated')) FROM simulated_part")
              .getInt() != 0) {
    return std::nullopt;
  }
  return "its table simulated_part holds what Foveola does not write";
}

void mark_as_part(SQLite::Database& study, const ShardedStudy& whole) {
  if (!study.tableExists("simulated_part")) {
    study.exec(simulated_part_sql);
  }
  study.exec("DELETE FROM simulated_part");
  SQLite::Statement row(study, "INSERT INTO simulated_part VALUES (?, ?)");
  SQLite::bind(row, whole.seed, whole.participants);
  row.exec();
}

std::vector<std::string> missing_participants(SQLite::Database& study, const ShardedStudy& whole) {
  SQLite::Statement rows(study,
                         "SELECT design_row FROM session WHERE kind = 'simulated' AND design_row "
                         "NOT NULL AND seed = ?");
  rows.bind(1, whole.seed);
  std::set<int> there;
  while (rows.executeStep()) {
    there.insert(whole_number<int>(rows.getColumn(0)));
  }
  std::vector<std::string> missing;
  for (int row = 0; row < whole.participants; ++row) {
    if (!there.contains(row)) {
      missing.push_back(participant_code(row));
    }
  }
  return missing;
}

}  // namespace foveola::study
