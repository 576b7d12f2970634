#include "study/record/data_quality_records.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include "renderer/base/parallel.h"
#include "study/record/database.h"
#include "study/record/recorded_frames.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

double seconds_of(Nanoseconds duration) { return static_cast<double>(duration.count()) * 1e-9; }

/// Sums over an attempt's frames, or over those of a session, for FrameFigures.
class FrameSums {
 public:
  FrameSums() = default;
  FrameSums(const std::vector<FrameRow>& frames, const std::vector<Nanoseconds>& marks) {
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

  void add(const FrameSums& attempt) {
    const FrameFigures& more = attempt.figures_;
    figures_.frames += more.frames;
    figures_.late += more.late;
    figures_.untracked += more.untracked;
    figures_.mean_gaze_age_s += more.mean_gaze_age_s;
    figures_.mean_to_display_s += more.mean_to_display_s;
    figures_.longest_frame_s = std::max(figures_.longest_frame_s, more.longest_frame_s);
    figures_.marks += more.marks;
    figures_.mean_mark_after_frame_s += more.mean_mark_after_frame_s;
    figures_.longest_mark_after_frame_s =
        std::max(figures_.longest_mark_after_frame_s, more.longest_mark_after_frame_s);
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

/// The last attempt at a test trial, with what is kept of it.
struct CountedAttempt {
  std::int64_t session = 0;
  std::string participant;
  std::size_t trial = 0;
  int attempt = 0;
  std::vector<StoredFrames> frames;
  std::vector<Nanoseconds> marks;  ///< session clock; without right-censored ones

  FrameSums sums() const {
    try {
      return {decode_stored(frames), marks};
    } catch (const std::invalid_argument&) {
      throw changed_frames(session, trial, attempt);
    }
  }
};

/// Walks through the counted attempts that have frames, session by session.
class AttemptRows {
 public:
  explicit AttemptRows(SQLite::Database& database)
      : attempts_(database,
                  "SELECT attempt.session, session.participant, attempt.trial,"
                  "  max(attempt.attempt), attempt.first_frame_ns"
                  " FROM attempt JOIN session ON session.id = attempt.session"
                  " JOIN planned_trial USING (session, trial)"
                  " WHERE planned_trial.kind = 'test' AND state <> 'withdrawn'"
                  "  AND EXISTS (SELECT 1 FROM frame_chunk AS chunk"
                  "   WHERE chunk.session = attempt.session AND chunk.trial = attempt.trial"
                  "   AND chunk.attempt = attempt.attempt)"
                  " GROUP BY attempt.session, attempt.trial"
                  " ORDER BY attempt.session, attempt.trial"),
        frames_(database,
                "SELECT * FROM frame_chunk WHERE session = ? AND trial = ? AND attempt = ?"
                " ORDER BY first_frame"),
        marks_(database,
               "SELECT time_ns FROM mark WHERE session = ? AND trial = ? AND attempt = ?"
               " AND censored = 0") {}

  /// Empty behind the last, as often as it is asked.
  std::optional<CountedAttempt> next() {
    if (attempts_.isDone() || !attempts_.executeStep()) {
      return std::nullopt;
    }
    CountedAttempt counted{attempts_.getColumn(0).getInt64(), attempts_.getColumn(1).getString(),
                           static_cast<std::size_t>(attempts_.getColumn(2).getInt64()),
                           attempts_.getColumn(3).getInt()};
    const Nanoseconds first_frame(attempts_.getColumn(4).getInt64());
    start(frames_, counted);
    while (frames_.executeStep()) {
      counted.frames.push_back(stored_frames(frames_));
    }
    start(marks_, counted);
    while (marks_.executeStep()) {
      counted.marks.push_back(first_frame + Nanoseconds(marks_.getColumn(0).getInt64()));
    }
    return counted;
  }

 private:
  static void start(SQLite::Statement& rows, const CountedAttempt& of) {
    rows.reset();
    SQLite::bind(rows, of.session, static_cast<std::int64_t>(of.trial), of.attempt);
  }

  SQLite::Statement attempts_;
  SQLite::Statement frames_;
  SQLite::Statement marks_;
};

/// As many attempts as are decoded at the same time: enough for every core, little enough to hold.
std::vector<CountedAttempt> next_batch(AttemptRows& rows) {
  constexpr std::size_t most_attempts = 256;
  constexpr std::int64_t most_frames = 1'000'000;
  std::vector<CountedAttempt> batch;
  for (std::int64_t frames = 0; batch.size() < most_attempts && frames < most_frames;) {
    std::optional<CountedAttempt> attempt = rows.next();
    if (!attempt) {
      break;
    }
    for (const StoredFrames& chunk : attempt->frames) {
      frames += chunk.count;
    }
    batch.push_back(std::move(*attempt));
  }
  return batch;
}

/// One thread reads, all of them uncompress and sum, and attempts are added in their order.
std::vector<FrameFigures> read_frames(SQLite::Database& database) {
  std::vector<FrameFigures> figures;
  AttemptRows rows(database);
  const Workers workers;
  CountedAttempt last;
  FrameSums session;
  for (std::vector<CountedAttempt> batch = next_batch(rows); !batch.empty();
       batch = next_batch(rows)) {
    std::vector<FrameSums> sums(batch.size());
    workers.for_each_block(batch.size(), 1,
                           [&](std::size_t i, std::size_t /*end*/) { sums[i] = batch[i].sums(); });
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (!last.participant.empty() && batch[i].session != last.session) {
        figures.push_back(session.figures(last.participant));
        session = FrameSums();
      }
      session.add(sums[i]);
      last.session = batch[i].session;
      last.participant = batch[i].participant;
    }
  }
  if (!last.participant.empty()) {
    figures.push_back(session.figures(last.participant));
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

DataQualityRecords read_data_quality(const fs::path& path) {
  DataQualityRecords records;
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
