// One session's part in what verify_study looks for.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <SQLiteCpp/Database.h>

#include "study/record/maintenance.h"
#include "study/record/prepared_statements.h"

namespace foveola::study {

/// The rows of the study itself in a new database in memory, where its sessions' events can be gone
/// through again.
SQLite::Database without_sessions(SQLite::Database& study);

/// A session of a study, by its row and its participant's code.
struct SessionKey {
  std::int64_t id = 0;
  std::string participant;
};

/// What is found in `sessions`, which lie side by side in the order of their ids. `blank` is
/// without_sessions(study), and is so afterwards. Throws what SQLite throws.
Verification check_sessions(PreparedStatements& study, PreparedStatements& blank,
                            std::span<const SessionKey> sessions);

}  // namespace foveola::study
