// Marks gaze samples with what the eye did: fixations, saccades and blinks.
#pragma once

#include <span>
#include <vector>

#include "renderer/gaze/eye_movements.h"

namespace foveola {

/// A movement is known only when it is over, so samples come out later than they go in, but in the
/// same order. A sample belongs to the movement that led to it, also if it is itself invalid. A
/// time without data is a blink if it does not last longer than longest_hold.
class GazeMarker {
 public:
  explicit GazeMarker(const EyeMovementSettings& settings = {}) : detector_(settings) {}

  /// Takes the stream's next sample, and appends to `marked` those whose mark is known now.
  void push(const GazeSample& sample, std::vector<GazeSample>& marked);
  /// Appends the rest, as what was going on up to the last one. The marker is then as new.
  void finish(std::vector<GazeSample>& marked);

 private:
  /// Appends the samples that belong to a movement that is over.
  void take(const EyeMovement& movement, std::vector<GazeSample>& marked);

  EyeMovementDetector detector_;
  std::vector<GazeSample> waiting_;
};

/// Successive samples of one mark.
struct MarkedMovement {
  GazeMark mark = GazeMark::none;
  std::span<const GazeSample> samples;  ///< never none
  /// From its first sample to the first one of the next movement, or to its own last one; not below
  /// zero.
  Nanoseconds duration{0};
};

/// The movements of marked samples, in their order; `samples` must outlive them.
std::vector<MarkedMovement> marked_movements(std::span<const GazeSample> samples);

}  // namespace foveola
