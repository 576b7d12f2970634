#include "study/record/instrument_records.h"

#include <algorithm>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include "study/record/database.h"
#include "study/record/recorded_frames.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

double seconds_of(Nanoseconds duration) { return static_cast<double>(duration.count()) * 1e-9; }

/// Sums over a session's attempts, for FrameFigures.
class FrameSums {
 public:
  void add_attempt(const std::vector<FrameRow>& frames, const std::vector<Nanoseconds>& marks) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      add_frame(frames[i]);
      if (i > 0) {
        const Nanoseconds step = frames[i].presented - frames[i - 1].presented;
        figures_.longest_frame_s = std::max(figures_.longest_frame_s, seconds_of(step));
      }
    }
    for (const Nanoseconds mark : marks) {
      add_mark(frames, mark);
    }
  }

  FrameFigures figures(std::string participant) const {
    FrameFigures result = figures_;
    result.participant = std::move(participant);
    const auto frames = static_cast<double>(std::max<std::uint64_t>(result.frames, 1));
    const auto marks = static_cast<double>(std::max<std::uint64_t>(result.marks, 1));
    result.mean_gaze_age_s /= frames;
    result.mean_to_display_s /= frames;
    result.mean_mark_after_frame_s /= marks;
    return result;
  }

 private:
  void add_frame(const FrameRow& frame) {
    ++figures_.frames;
    figures_.late += frame.is_late ? 1 : 0;
    figures_.untracked += frame.gaze_valid ? 0 : 1;
    figures_.mean_gaze_age_s += seconds_of(frame.gaze_age);
    figures_.mean_to_display_s += seconds_of(frame.presented - frame.time);
  }

  /// A mark belongs to the last frame that was on the display before it.
  void add_mark(const std::vector<FrameRow>& frames, Nanoseconds mark) {
    const auto later = std::upper_bound(
        frames.begin(), frames.end(), mark,
        [](Nanoseconds time, const FrameRow& row) { return time < row.presented; });
    if (later == frames.begin()) {
      return;
    }
    const double after = seconds_of(mark - std::prev(later)->presented);
    ++figures_.marks;
    figures_.mean_mark_after_frame_s += after;
    figures_.longest_mark_after_frame_s = std::max(figures_.longest_mark_after_frame_s, after);
  }

  FrameFigures figures_;  ///< means are sums still
};

struct AttemptKey {
  std::int64_t session = 0;
  std::string participant;
  std::size_t trial = 0;
  int attempt = 0;
  Nanoseconds first_frame{0};
};

/// The last attempts at the test trials, session by session.
std::vector<AttemptKey> counted_attempts(SQLite::Database& database) {
  std::vector<AttemptKey> attempts;
  SQLite::Statement rows(
      database,
      "SELECT attempt.session, session.participant, attempt.trial, max(attempt.attempt),"
      "  attempt.first_frame_ns"
      " FROM attempt JOIN session ON session.id = attempt.session"
      " JOIN planned_trial USING (session, trial)"
      " WHERE planned_trial.kind = 'test' AND state <> 'withdrawn'"
      "  AND EXISTS (SELECT 1 FROM frame_chunk AS chunk WHERE chunk.session = attempt.session"
      "   AND chunk.trial = attempt.trial AND chunk.attempt = attempt.attempt)"
      " GROUP BY attempt.session, attempt.trial ORDER BY attempt.session, attempt.trial");
  while (rows.executeStep()) {
    attempts.push_back({rows.getColumn(0).getInt64(), rows.getColumn(1).getString(),
                        static_cast<std::size_t>(rows.getColumn(2).getInt64()),
                        rows.getColumn(3).getInt(), Nanoseconds(rows.getColumn(4).getInt64())});
  }
  return attempts;
}

/// When marks were made, by the session's clock; not those that timed out.
std::vector<Nanoseconds> marks_of(SQLite::Database& database, const AttemptKey& key) {
  std::vector<Nanoseconds> marks;
  SQLite::Statement rows(database,
                         "SELECT time_ns FROM mark WHERE session = ? AND trial = ? AND attempt = ?"
                         " AND censored = 0");
  SQLite::bind(rows, key.session, static_cast<std::int64_t>(key.trial), key.attempt);
  while (rows.executeStep()) {
    marks.push_back(key.first_frame + Nanoseconds(rows.getColumn(0).getInt64()));
  }
  return marks;
}

std::vector<FrameFigures> read_frames(SQLite::Database& database) {
  std::vector<FrameFigures> figures;
  FrameSums sums;
  const std::vector<AttemptKey> attempts = counted_attempts(database);
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    const AttemptKey& key = attempts[i];
    sums.add_attempt(frames_of(database, key.session, key.trial, key.attempt),
                     marks_of(database, key));
    if (i + 1 == attempts.size() || attempts[i + 1].session != key.session) {
      figures.push_back(sums.figures(key.participant));
      sums = FrameSums();
    }
  }
  return figures;
}

std::optional<double> angle(SQLite::Statement& row, const char* column) {
  const SQLite::Column value = row.getColumn(column);
  return value.isNull() ? std::nullopt : std::optional(value.getDouble());
}

std::vector<GazeRunRow> read_gaze_runs(SQLite::Database& database) {
  std::vector<GazeRunRow> runs;
  SQLite::Statement rows(database,
                         "SELECT participant, run, accuracy_deg, precision_rms_deg, data_loss,"
                         " passed FROM gaze_run JOIN session ON session.id = session"
                         " WHERE state <> 'withdrawn' ORDER BY session, run");
  while (rows.executeStep()) {
    runs.push_back({rows.getColumn("participant").getString(), rows.getColumn("run").getInt(),
                    angle(rows, "accuracy_deg"), angle(rows, "precision_rms_deg"),
                    rows.getColumn("data_loss").getDouble(),
                    rows.getColumn("passed").getInt() == 1});
  }
  return runs;
}

std::vector<ReactionRow> read_reactions(SQLite::Database& database) {
  std::vector<ReactionRow> reactions;
  SQLite::Statement rows(database,
                         "SELECT participant, pressed_ns - shown_ns AS taken_ns, early"
                         " FROM reaction JOIN session ON session.id = session"
                         " WHERE state <> 'withdrawn' ORDER BY session, number");
  while (rows.executeStep()) {
    reactions.push_back({rows.getColumn("participant").getString(),
                         seconds_of(Nanoseconds(rows.getColumn("taken_ns").getInt64())),
                         rows.getColumn("early").getInt() == 1});
  }
  return reactions;
}

}  // namespace

InstrumentRecords read_instrument(const fs::path& path) {
  InstrumentRecords records;
  with_clear_errors(path, [&] {
    SQLite::Database database = open_study_to_read(path);
    const SQLite::Transaction moment(database);
    records.frames = read_frames(database);
    records.gaze_runs = read_gaze_runs(database);
    records.reactions = read_reactions(database);
  });
  return records;
}

}  // namespace foveola::study
