// What all simulated participants have in common, whether they look or only pretend to.
#pragma once

#include "study/participant/evidence.h"
#include "study/participant/participant.h"
#include "study/participant/scan_path.h"

namespace foveola::study {

class SimulatedObserver : public Participant {
 public:
  /// What see() does once it is known what there is to see: for looks that were not made of pixels.
  virtual std::optional<Nanoseconds> consider(const Evidence& evidence, Nanoseconds now) = 0;

  /// Whether anything that is shown makes a difference: otherwise evidence may be empty.
  virtual bool looks() const = 0;

  /// What gaze() and head() follow, to be walked through fixation by fixation.
  virtual ScanPath& path() = 0;
};

}  // namespace foveola::study
