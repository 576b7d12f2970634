// Iterates over a study's attempts and loads the frames, gaze, marks and devices of each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <SQLiteCpp/Statement.h>

#include "renderer/view/viewport.h"
#include "study/record/read/recorded_frames.h"
#include "study/record/read/recorded_gaze.h"

namespace foveola::study {

/// One timing of a trial with what is kept of it, compressed still.
struct KeptAttempt {
  std::int64_t session = 0;
  std::string participant;
  std::size_t trial = 0;  ///< in the session's plan, from 0
  int attempt = 1;
  bool counts = false;              ///< whether it is the last with frames at a test trial
  std::string object;               ///< the chosen one's name
  std::string shown_as;             ///< the text that schema.sql describes at session_scene
  std::optional<FieldOfView> view;  ///< as it was then; empty if the record does not say
  std::string tracker;  ///< its profile's name, or "simulated"; empty if the record does not say
  std::vector<StoredChunk> frames;
  std::vector<StoredChunk> gaze;
  std::vector<MarkedMoment> marks;  ///< session clock, in the order of time

  /// Decodes what is kept. Throw Error if it is not what was written.
  std::vector<FrameRow> decoded_frames() const;
  std::vector<GazeSample> decoded_gaze() const;
};

/// Walks through the attempts that have frames, by session, trial and attempt; none of withdrawn
/// sessions.
class KeptAttempts {
 public:
  /// database: must outlive it. Throws SQLite::Exception, as next() does.
  explicit KeptAttempts(SQLite::Database& database);

  /// Returns the next attempt; nullopt after the last one.
  std::optional<KeptAttempt> next();

 private:
  /// A session's display and tracker, from a time of its clock on.
  struct Devices {
    Nanoseconds since{0};
    std::optional<FieldOfView> view;
    std::string tracker;
  };

  Devices devices_of(const std::string& devices, Nanoseconds since, bool is_simulated) const;
  /// Reads devices_ anew if the session is another than that of the attempt before.
  void follow_session(std::int64_t session);

  SQLite::Statement attempts_;
  SQLite::Statement sessions_;
  SQLite::Statement notes_;
  SQLite::Statement scenes_;
  ChunkReader frames_;
  ChunkReader gaze_;
  SQLite::Statement marks_;
  std::optional<FieldOfView> simulated_view_;  ///< what simulated participants saw through
  std::optional<std::int64_t> session_;
  std::vector<Devices> devices_;  ///< of session_, in the order of time; never none
};

}  // namespace foveola::study
