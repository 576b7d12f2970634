// The marks of a recorded attempt.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "renderer/base/clock.h"

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

}  // namespace foveola::study
