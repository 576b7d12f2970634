// The interface of all simulated participants, whether they judge images or press at drawn times.
#pragma once

#include "study/participant/observer/evidence.h"
#include "study/participant/observer/scan_path.h"
#include "study/participant/participant.h"

namespace foveola::study {

class SimulatedObserver : public Participant {
 public:
  /// The part of see() after the evidence is known; used alone for predicted glances, which have no
  /// pixels.
  virtual std::optional<Nanoseconds> consider(const Evidence& evidence, Nanoseconds now) = 0;

  /// Whether the participant judges what is shown; otherwise evidence may be empty.
  virtual bool looks() const = 0;

  /// The scan path that gaze() and head() follow.
  virtual ScanPath& path() = 0;
};

}  // namespace foveola::study
