// One session's part in what verify_study looks for.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "study/record/maintain/maintenance.h"
#include "study/record/sqlite/prepared_statements.h"

namespace foveola::study {

/// A session of a study, by its row and its participant's code.
struct SessionKey {
  std::int64_t id = 0;
  std::string participant;
};

/// Runs a check. A value that makes it fail, a number or JSON that Foveola never writes, is a fault
/// of the participant's session, or of the study if `participant` is empty. Throws what else SQLite
/// throws.
void run_check(Verification& found, const std::string& participant,
               const std::function<void()>& check);

/// What is found in `sessions`. Throws what SQLite throws.
Verification check_sessions(PreparedStatements& study, std::span<const SessionKey> sessions);

}  // namespace foveola::study
