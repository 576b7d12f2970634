// A study that is recorded as the program does it, on a disk that is watched.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "power_loss_disk.h"
#include "small_study.h"

namespace foveola::study {

/// How much of each kind a study holds.
struct Holdings {
  std::size_t sessions = 0;
  std::size_t events = 0;
  std::size_t frame_chunks = 0;
  std::size_t gaze_chunks = 0;
  std::size_t film_hashes = 0;

  friend bool operator==(const Holdings&, const Holdings&) = default;
};

struct TimedEvent {
  Nanoseconds time{0};
  std::string name;

  friend bool operator==(const TimedEvent&, const TimedEvent&) = default;
};

/// What was done to a folder, and what is known of the study in it.
struct RecordedStudy {
  std::vector<DiskCall> calls;
  std::vector<Holdings> commits;
  std::vector<TimedEvent> events;
};

/// Both are recorded once for all tests, at study.sqlite, with two sessions of small_protocol().
const RecordedStudy& short_study();
/// In the first of its sessions come 4 MB of a log together, at which SQLite folds it in.
const RecordedStudy& long_study();

}  // namespace foveola::study
