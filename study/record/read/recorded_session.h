// A session as it stands in a study's file, with all that it takes to show it again.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/protocol/protocol.h"
#include "study/record/setup/simulation_kind.h"
#include "study/record/write/study_store.h"

namespace foveola::study {

/// An attempt at a trial.
struct RecordedAttempt {
  std::size_t trial = 0;  ///< index into the plan
  int attempt = 1;
  int timing = 1;

  friend bool operator==(const RecordedAttempt&, const RecordedAttempt&) = default;
};

struct RecordedSession {
  KnownSession known;
  std::vector<std::string> programs;         ///< that showed it, by programs_of()
  std::string processor;                     ///< the processor it ran on
  std::optional<FieldOfView> view;           ///< the display's; only of a person's session
  std::optional<SimulationKind> simulation;  ///< only of a simulated session
  Plan plan;
  Procedure procedure;
  std::vector<LoggedEvent> events;        ///< in their order
  std::vector<RecordedAttempt> attempts;  ///< in the order of time
};

/// What was rendered in an attempt.
struct RecordedFrames {
  std::vector<FrameRow> frames;  ///< those that reached the disk
  std::vector<FilmHash> hashes;  ///< in the order of frames
};

/// Throws Error if the file at `path` is no study, or there is no such participant.
RecordedSession read_session(const std::filesystem::path& path, const std::string& participant);

/// Throws Error if they are not what was written.
RecordedFrames read_frames(const std::filesystem::path& path, const KnownSession& session,
                           const RecordedAttempt& attempt);

/// The study's protocol by the text that its file keeps. folder: where the files lie that the
/// protocol names by a path. Throws Error if one of them, or a profile, is another now.
Protocol read_recorded_protocol(const std::filesystem::path& path,
                                const std::filesystem::path& folder);

}  // namespace foveola::study
