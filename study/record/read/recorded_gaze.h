// The gaze and the marks of a recorded session, to be looked at or replayed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/gaze/eye_tracker.h"
#include "study/record/log/chunk.h"

namespace SQLite {
class Database;
class Statement;
}  // namespace SQLite

namespace foveola::study {

/// A mark of an attempt, or the moment at which the wait for it ended.
struct MarkedMoment {
  std::string mark;       ///< its name in the protocol
  Nanoseconds time{0};    ///< session clock
  bool censored = false;  ///< right-censored: no mark came in time
};

/// The query by which read_marks reads, prepared once for many attempts; `database` must outlive
/// it.
SQLite::Statement query_of_marks(SQLite::Database& database);

/// The attempt's marks in the order of time; first_frame: when its first frame was presented.
/// Throws what SQLite throws.
std::vector<MarkedMoment> read_marks(SQLite::Statement& query, std::int64_t session,
                                     std::size_t trial, int attempt, Nanoseconds first_frame);

/// The samples of all chunks of an attempt, in their order. Throws std::invalid_argument if they
/// are not what was written.
std::vector<GazeSample> gaze_in(const std::vector<StoredChunk>& chunks);

/// The samples of the participant's last attempt at a trial, 0 being the first, in the order of
/// their arrival; times are of the session's clock. Throws Error if the file is no study, there are
/// none, or they are not what was written.
std::vector<GazeSample> read_gaze(const std::filesystem::path& path, const std::string& participant,
                                  std::size_t trial);

/// One timing of a trial with all of its gaze; times are of the session's clock.
struct AttemptGaze {
  std::string participant;
  std::size_t trial = 0;   ///< in the session's plan, from 0
  std::string trial_kind;  ///< "test", "practice" or "catch"
  std::string scene;
  std::string method;
  int attempt = 1;
  std::string outcome;  ///< one of the names in schema.sql
  std::optional<Nanoseconds> first_frame;
  std::vector<MarkedMoment> marks;  ///< in the order of time
  std::vector<GazeSample> samples;  ///< in the order of their arrival; never none
};

/// Calls `visit` for every attempt that has gaze, session by session in the order of time; one is
/// in memory at a time. None of withdrawn sessions. Throws Error as read_gaze, and what `visit`
/// throws.
void visit_gaze(const std::filesystem::path& path,
                const std::function<void(const AttemptGaze&)>& visit);

}  // namespace foveola::study
