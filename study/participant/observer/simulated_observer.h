// The interface of all simulated participants, whether they judge images or press at drawn times.
#pragma once

#include "study/participant/observer/evidence.h"
#include "study/participant/observer/scan_path.h"
#include "study/participant/participant.h"

namespace foveola::study {

class SimulatedObserver : public Participant {
 public:
  /// The part of see() after the evidence is known. Predicted glances, which have no pixels, use it
  /// alone.
  virtual std::optional<Nanoseconds> consider(const Evidence& evidence, Nanoseconds now) = 0;

  /// Whether the participant judges images; otherwise evidence may be empty.
  virtual bool looks() const = 0;

  /// Returns the scan path that gaze() and head() follow.
  virtual ScanPath& path() = 0;
};

}  // namespace foveola::study
