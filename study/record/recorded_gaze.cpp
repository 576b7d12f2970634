#include "study/record/recorded_gaze.h"

#include <stdexcept>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "study/record/chunk.h"
#include "study/record/damage_remedy.h"
#include "study/record/database.h"
#include "study/record/gaze_encoding.h"
#include "study/record/stored_number.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

std::vector<GazeSample> samples_of(SQLite::Statement& rows, const fs::path& path) {
  std::vector<StoredChunk> chunks;
  while (rows.executeStep()) {
    chunks.push_back(stored_chunk(rows));
  }
  try {
    return gaze_in(chunks);
  } catch (const std::invalid_argument&) {
    throw Error(path.string(), "its gaze samples are not those that were written", damage_remedy);
  }
}

/// Reads attempts' chunks and marks, with statements that are prepared once.
class AttemptReader {
 public:
  AttemptReader(SQLite::Database& database, const fs::path& path)
      : path_(path),
        chunks_(
            database,
            fmt::format("SELECT {} FROM gaze_chunk"
                        " WHERE session = ? AND trial = ? AND attempt = ? ORDER BY first_sample",
                        columns_of_chunk(database, "gaze_chunk"))),
        marks_(query_of_marks(database)) {}

  void read(std::int64_t session, AttemptGaze& attempt) {
    chunks_.reset();
    SQLite::bind(chunks_, session, static_cast<std::int64_t>(attempt.trial), attempt.attempt);
    attempt.samples = samples_of(chunks_, path_);
    attempt.marks = read_marks(marks_, session, attempt.trial, attempt.attempt,
                               attempt.first_frame.value_or(Nanoseconds(0)));
  }

 private:
  fs::path path_;
  SQLite::Statement chunks_;
  SQLite::Statement marks_;
};

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
    AttemptReader reader(database, path);
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
      reader.read(rows.getColumn("session").getInt64(), attempt);
      visit(attempt);
    }
  });
}

std::vector<GazeSample> read_gaze(const fs::path& path, const std::string& participant,
                                  std::size_t trial) {
  std::vector<GazeSample> samples;
  with_clear_errors(path, [&] {
    SQLite::Database database = open_study_to_read(path);
    SQLite::Statement chunks(
        database,
        fmt::format("SELECT {} FROM gaze_chunk JOIN session ON session.id = gaze_chunk.session"
                    " WHERE participant = ? AND trial = ?"
                    " AND attempt = (SELECT max(attempt) FROM attempt"
                    "  WHERE attempt.session = gaze_chunk.session"
                    "   AND attempt.trial = gaze_chunk.trial) ORDER BY first_sample",
                    columns_of_chunk(database, "gaze_chunk")));
    SQLite::bind(chunks, participant, static_cast<std::int64_t>(trial));
    samples = samples_of(chunks, path);
  });
  if (samples.empty()) {
    throw Error(path.string(),
                fmt::format("has no gaze of participant {} in trial {}", participant, trial),
                "foveola study status says whose sessions there are; the first trial is 0");
  }
  return samples;
}

}  // namespace foveola::study
