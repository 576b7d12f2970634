#include "study/record/measured.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "renderer/base/files/digest.h"

namespace foveola::study {
namespace {

/// rows: a count and a hash each, in their order.
std::string count_and_digest(PreparedStatements& statements, const char* rows, std::int64_t session,
                             std::int64_t trial, std::int64_t attempt) {
  PreparedStatement row(statements, rows);
  SQLite::bind(*row, session, trial, attempt);
  std::uint64_t count = 0;  // wraps around where numbers are not what was written
  std::string hashes;
  while (row->executeStep()) {
    count += static_cast<std::uint64_t>(row->getColumn(0).getInt64());
    hashes += (hashes.empty() ? "" : "\n") + row->getColumn(1).getString();
  }
  return fmt::format(R"({{"count":{},"sha256":"{}"}})", count, sha256(hashes));
}

}  // namespace

bool is_in_attempt(const SessionState& state) {
  return state.phase == Phase::armed || state.phase == Phase::marking ||
         state.phase == Phase::rating;
}

bool is_same_attempt(const SessionState& a, const SessionState& b) {
  return is_in_attempt(a) && is_in_attempt(b) && a.step == b.step && a.attempt == b.attempt;
}

std::string measured_in(PreparedStatements& statements, std::int64_t session, std::int64_t trial,
                        std::int64_t attempt) {
  const auto of = [&](const char* rows) {
    return count_and_digest(statements, rows, session, trial, attempt);
  };
  return fmt::format(R"({{"frames":{},"gaze":{},"films":{}}})",
                     of("SELECT frame_count, data_sha256 FROM frame_chunk"
                        " WHERE session = ? AND trial = ? AND attempt = ? ORDER BY first_frame"),
                     of("SELECT sample_count, data_sha256 FROM gaze_chunk"
                        " WHERE session = ? AND trial = ? AND attempt = ? ORDER BY first_sample"),
                     of("SELECT 1, row_sha256 FROM film_hash"
                        " WHERE session = ? AND trial = ? AND attempt = ? ORDER BY frame"));
}

EventAttempt attempt_of_event(PreparedStatements& statements, std::int64_t session,
                              const Procedure& procedure, const SessionState& before,
                              const SessionState& after) {
  if (!is_in_attempt(before) && !is_in_attempt(after)) {
    return {};
  }
  const SessionState& state = is_in_attempt(before) ? before : after;
  const auto trial = static_cast<std::int64_t>(trial_of(procedure, state).value());
  const bool ends_it = is_in_attempt(before) && !is_same_attempt(before, after);
  return {.trial = trial,
          .attempt = state.attempt,
          .measured = ends_it ? measured_in(statements, session, trial, state.attempt) : ""};
}

}  // namespace foveola::study
