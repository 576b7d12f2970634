#include "study/record/read/data_quality_records.h"

#include <algorithm>
#include <utility>

#include <SQLiteCpp/SQLiteCpp.h>

#include "renderer/base/work/parallel.h"
#include "study/record/read/kept_attempts.h"
#include "study/record/setup/routine_notes.h"
#include "study/record/sqlite/database.h"
#include "study/record/sqlite/stored_number.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

double seconds_of(Nanoseconds duration) { return static_cast<double>(duration.count()) * 1e-9; }

/// Sums over an attempt's frames, or over those of a session, for FrameFigures.
class FrameSums {
 public:
  FrameSums() = default;
  FrameSums(const std::vector<FrameRow>& frames, const std::vector<MarkedMoment>& marks) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      add_frame(frames[i]);
      if (i > 0) {
        const Nanoseconds step = frames[i].presented - frames[i - 1].presented;
        figures_.longest_frame_s = std::max(figures_.longest_frame_s, seconds_of(step));
      }
    }
    for (const MarkedMoment& mark : marks) {
      if (!mark.censored) {
        add_mark(frames, mark.time);
      }
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
    figures_.untracked += has_gaze(frame) ? 0 : 1;
    figures_.mean_gaze_age_s += seconds_of(frame.gaze_age);
    figures_.mean_to_display_s += seconds_of(frame.presented - frame.time);
  }

  /// A mark belongs to the last frame that was on the display before it.
  void add_mark(const std::vector<FrameRow>& frames, Nanoseconds mark) {
    const FrameRow* const frame = frame_on_display(frames, mark);
    if (frame == nullptr) {
      return;
    }
    const double after = seconds_of(mark - frame->presented);
    ++figures_.marks;
    figures_.mean_mark_after_frame_s += after;
    figures_.longest_mark_after_frame_s = std::max(figures_.longest_mark_after_frame_s, after);
  }

  FrameFigures figures_;  ///< means are sums still
};

/// What follows from one attempt.
struct AttemptFigures {
  FrameSums sums;
  AttemptGazeFigures gaze;
};

AttemptFigures figures_of(const KeptAttempt& kept) {
  const WatchedAttempt watched{.frames = kept.decoded_frames(),
                               .samples = kept.decoded_gaze(),
                               .marks = kept.marks,
                               .object = object_in(kept.shown_as, kept.object),
                               .view = kept.view};
  return {.sums = {watched.frames, watched.marks}, .gaze = attempt_gaze_figures(watched)};
}

/// As many attempts as are decoded at the same time: enough for every core, little enough to hold.
std::vector<KeptAttempt> next_batch(KeptAttempts& attempts) {
  constexpr std::size_t max_attempts = 256;
  constexpr std::int64_t max_rows = 1'000'000;
  std::vector<KeptAttempt> batch;
  for (std::int64_t rows = 0; batch.size() < max_attempts && rows < max_rows;) {
    std::optional<KeptAttempt> attempt = attempts.next();
    if (!attempt) {
      break;
    }
    for (const StoredChunk& chunk : attempt->frames) {
      rows += chunk.count;
    }
    for (const StoredChunk& chunk : attempt->gaze) {
      rows += chunk.count;
    }
    batch.push_back(std::move(*attempt));
  }
  return batch;
}

/// Adds up the frames of each session's counted attempts.
class SessionFrames {
 public:
  explicit SessionFrames(std::vector<FrameFigures>& figures) : figures_(figures) {}

  /// Attempts come session by session.
  void add(const KeptAttempt& attempt, const FrameSums& sums) {
    if (attempt.participant != participant_) {
      finish();
    }
    participant_ = attempt.participant;
    sums_.add(sums);
  }

  void finish() {
    if (!participant_.empty()) {
      figures_.push_back(sums_.figures(participant_));
    }
    sums_ = FrameSums();
  }

 private:
  std::vector<FrameFigures>& figures_;
  std::string participant_;
  FrameSums sums_;
};

/// One thread reads, all of them uncompress and sum, and attempts are added in their order.
void read_attempts(SQLite::Database& database, DataQualityRecords& records) {
  KeptAttempts attempts(database);
  SessionFrames frames(records.frames);
  const Workers workers;
  for (std::vector<KeptAttempt> batch = next_batch(attempts); !batch.empty();
       batch = next_batch(attempts)) {
    std::vector<AttemptFigures> figures(batch.size());
    workers.for_each_block(batch.size(), 1, [&](std::size_t i, std::size_t /*end*/) {
      figures[i] = figures_of(batch[i]);
    });
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (batch[i].counts) {
        frames.add(batch[i], figures[i].sums);
      }
      records.gaze.push_back({.participant = batch[i].participant,
                              .trial = batch[i].trial,
                              .attempt = batch[i].attempt,
                              .tracker = batch[i].tracker,
                              .figures = std::move(figures[i].gaze)});
    }
  }
  frames.finish();
}

std::optional<double> angle(SQLite::Statement& row, const char* column) {
  const SQLite::Column value = row.getColumn(column);
  return value.isNull() ? std::nullopt : std::optional(finite_number(value));
}

std::vector<GazeRunRow> read_gaze_runs(SQLite::Database& database) {
  std::vector<GazeRunRow> runs;
  SQLite::Statement rows(database,
                         "SELECT participant, run, accuracy_deg, precision_rms_deg, data_loss,"
                         " passed FROM gaze_run JOIN session ON session.id = session"
                         " WHERE state <> 'withdrawn' ORDER BY session, run");
  while (rows.executeStep()) {
    runs.push_back({rows.getColumn("participant").getString(),
                    whole_number<int>(rows.getColumn("run")), angle(rows, "accuracy_deg"),
                    angle(rows, "precision_rms_deg"), finite_number(rows.getColumn("data_loss")),
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
                         seconds_of(time_from(rows.getColumn("taken_ns"))),
                         rows.getColumn("early").getInt() == 1});
  }
  return reactions;
}

std::vector<std::string> read_notes_to_read(SQLite::Statement& notes, std::int64_t session) {
  std::vector<std::string> texts;
  notes.reset();
  notes.bind(1, session);
  while (notes.executeStep()) {
    if (std::string text = notes.getColumn(0).getString(); !is_routine_note(text)) {
      texts.push_back(std::move(text));
    }
  }
  return texts;
}

/// A program that was killed could not say so: the one that goes on records the interruption.
std::vector<SessionCourse> read_courses(SQLite::Database& database) {
  std::vector<SessionCourse> courses;
  SQLite::Statement notes(database, "SELECT text FROM note WHERE session = ? ORDER BY sequence");
  SQLite::Statement rows(database,
                         "SELECT id, participant,"
                         " (SELECT count(*) FROM event WHERE session = session.id"
                         "  AND type = 'interrupted') AS interruptions,"
                         " (SELECT count(*) FROM attempt WHERE session = session.id"
                         "  AND outcome = 'interrupted') AS attempts_lost"
                         " FROM session WHERE state <> 'withdrawn' ORDER BY id");
  while (rows.executeStep()) {
    courses.push_back({.participant = rows.getColumn("participant").getString(),
                       .interruptions = whole_number<std::size_t>(rows.getColumn("interruptions")),
                       .attempts_lost = whole_number<std::size_t>(rows.getColumn("attempts_lost")),
                       .notes = read_notes_to_read(notes, rows.getColumn("id").getInt64())});
  }
  return courses;
}

}  // namespace

DataQualityRecords read_data_quality(const fs::path& path) {
  DataQualityRecords records;
  with_clear_errors(path, [&] {
    SQLite::Database database = open_study_to_read(path);
    const SQLite::Transaction moment(database);
    read_attempts(database, records);
    records.gaze_runs = read_gaze_runs(database);
    records.reactions = read_reactions(database);
    records.courses = read_courses(database);
    records.setups = session_setups(database);
  });
  return records;
}

}  // namespace foveola::study
