#include "study/record/read/recorded_gaze.h"

#include <stdexcept>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/record/log/chunk.h"
#include "study/record/log/encodings.h"
#include "study/record/sqlite/damage_remedy.h"
#include "study/record/sqlite/database.h"
#include "study/record/sqlite/stored_number.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

std::vector<GazeSample> samples_in(const std::vector<StoredChunk>& chunks, const fs::path& path) {
  try {
    return gaze_in(chunks);
  } catch (const std::invalid_argument&) {
    throw Error(path.string(), "its gaze samples are not those that were written", damage_remedy);
  }
}

AttemptGaze attempt_in(SQLite::Statement& row) {
  AttemptGaze attempt;
  attempt.participant = row.getColumn("participant").getString();
  attempt.trial = whole_number<std::size_t>(row.getColumn("trial"));
  attempt.trial_kind = row.getColumn("trial_kind").getString();
  attempt.scene = row.getColumn("scene").getString();
  attempt.method = row.getColumn("method").getString();
  attempt.attempt = whole_number<int>(row.getColumn("attempt"));
  attempt.outcome = row.getColumn("outcome").getString();
  if (const SQLite::Column first = row.getColumn("first_frame_ns"); !first.isNull()) {
    attempt.first_frame = time_from(first);
  }
  return attempt;
}

}  // namespace

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

std::vector<GazeSample> gaze_in(const std::vector<StoredChunk>& chunks) {
  std::vector<GazeSample> samples;
  for (const StoredChunk& chunk : chunks) {
    const std::vector<GazeSample> more = decode_gaze(chunk_bytes(chunk, bytes_per_gaze_sample));
    samples.insert(samples.end(), more.begin(), more.end());
  }
  return samples;
}

void visit_gaze(const fs::path& path, const std::function<void(const AttemptGaze&)>& visit) {
  with_clear_errors(path, [&] {
    SQLite::Database database = open_study_to_read(path);
    const SQLite::Transaction moment(database);
    ChunkReader chunks(database, "gaze_chunk");
    SQLite::Statement marks = query_of_marks(database);
    SQLite::Statement rows(
        database,
        "SELECT attempt.session, participant, attempt.trial, planned_trial.kind AS trial_kind,"
        "  scene, method, attempt, outcome, first_frame_ns"
        " FROM attempt JOIN session ON session.id = attempt.session"
        " JOIN planned_trial USING (session, trial)"
        " WHERE state <> 'withdrawn' AND EXISTS (SELECT 1 FROM gaze_chunk AS chunk"
        "  WHERE chunk.session = attempt.session AND chunk.trial = attempt.trial"
        "   AND chunk.attempt = attempt.attempt)"
        " ORDER BY attempt.session, attempt.trial, attempt.attempt");
    while (rows.executeStep()) {
      AttemptGaze attempt = attempt_in(rows);
      const std::int64_t session = rows.getColumn("session").getInt64();
      attempt.samples = samples_in(chunks.read(session, attempt.trial, attempt.attempt), path);
      attempt.marks = read_marks(marks, session, attempt.trial, attempt.attempt,
                                 attempt.first_frame.value_or(Nanoseconds(0)));
      visit(attempt);
    }
  });
}

std::vector<GazeSample> read_gaze(const fs::path& path, const std::string& participant,
                                  std::size_t trial) {
  std::vector<GazeSample> samples;
  with_clear_errors(path, [&] {
    SQLite::Database database = open_study_to_read(path);
    SQLite::Statement last(database,
                           "SELECT session, max(attempt) FROM attempt JOIN session"
                           " ON session.id = session WHERE participant = ? AND trial = ?");
    SQLite::bind(last, participant, static_cast<std::int64_t>(trial));
    last.executeStep();
    samples = samples_in(
        ChunkReader(database, "gaze_chunk")
            .read(last.getColumn(0).getInt64(), trial, whole_number<int>(last.getColumn(1))),
        path);
  });
  if (samples.empty()) {
    throw Error(path.string(),
                fmt::format("has no gaze of participant {} in trial {}", participant, trial),
                "foveola study status says whose sessions there are; the first trial is 0");
  }
  return samples;
}

}  // namespace foveola::study
