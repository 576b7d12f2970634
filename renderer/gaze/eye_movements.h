// Fixations, saccades and blinks in a stream of gaze samples, distinguished by the eye's velocity.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/eye_tracker.h"

namespace foveola {

enum class EyeMovementKind { fixation, saccade, no_data };

/// From one sample to a later one.
struct EyeMovement {
  EyeMovementKind kind = EyeMovementKind::no_data;
  Nanoseconds start{0};
  Nanoseconds end{0};
  Vec3 from{0.0F, 0.0F, -1.0F};    ///< direction at the start
  Vec3 to{0.0F, 0.0F, -1.0F};      ///< direction at the end; without data both are meaningless
  double fastest_deg_per_s = 0.0;  ///< the maximum velocity between its samples
};

struct EyeMovementSettings {
  /// Minimum velocity of a saccade (100 degrees per second: Salvucci and Goldberg 2000). Noise must
  /// stay well below it: at 120 Hz, 0.1 degrees of noise along each axis exceed 30 degrees per
  /// second a fifth of the time.
  double threshold_deg_per_s = 100.0;
  /// Shorter movements belong to their neighbour: about one sample at 120 Hz, and the minimum time
  /// between two saccades (both assumed).
  Nanoseconds shortest_saccade = std::chrono::milliseconds(8);
  Nanoseconds shortest_fixation = std::chrono::milliseconds(60);
  /// Maximum interval between valid samples in which the eye is assumed to move steadily. Longer
  /// ones have no data (assumed: the shortest blink lasts longer).
  Nanoseconds longest_interval = std::chrono::milliseconds(75);
};

/// Identification by a velocity threshold (I-VT, Salvucci and Goldberg 2000), sample by sample. The
/// velocity is the true angle between two successive valid samples over the time between them.
/// Movements are contiguous; the first one, and the first after a gap in the data, may be shorter
/// than the minimum.
class EyeMovementDetector {
 public:
  explicit EyeMovementDetector(const EyeMovementSettings& settings) : settings_(settings) {}

  /// Adds the next sample. Returns the movements now known to have ended, at most two, in order of
  /// time. Ignores a sample that is not later than the one before.
  std::vector<EyeMovement> push(const GazeSample& sample);
  /// Returns the movement up to the last sample, if any, and resets the detector.
  std::optional<EyeMovement> finish();

  /// Kind by the newest two valid samples, before its duration is known; no data if the newest
  /// sample is invalid or the only one.
  EyeMovementKind now() const { return now_; }

 private:
  /// Begins a gap after the last valid sample.
  void begin_no_data(std::vector<EyeMovement>& over);
  /// Adds the movement between two successive valid samples.
  void add(const EyeMovement& step, std::vector<EyeMovement>& over);
  EyeMovement step_to(const GazeSample& sample) const;
  Nanoseconds shortest(EyeMovementKind kind) const;
  /// Ends the current movement, including one that was too short to count.
  std::optional<EyeMovement> take_going_on();

  EyeMovementSettings settings_;
  EyeMovementKind now_ = EyeMovementKind::no_data;
  std::optional<Nanoseconds> last_time_;
  std::optional<GazeSample> last_valid_;  ///< start of the next step; nullopt in a gap
  std::optional<EyeMovement> going_on_;
  std::optional<EyeMovement> beginning_;  ///< a movement of another kind that is still too short
};

/// Marks samples with their movement. A movement is known only when it has ended, so samples come
/// out later than they go in, in the same order. A sample belongs to the movement that led to it,
/// also if it is itself invalid. A gap in the data is a blink if it is not longer than
/// longest_hold.
class GazeMarker {
 public:
  explicit GazeMarker(const EyeMovementSettings& settings = {}) : detector_(settings) {}

  /// Adds the next sample, and appends the samples whose mark is now known to `marked`.
  void push(const GazeSample& sample, std::vector<GazeSample>& marked);
  /// Appends the rest, marked with the current movement, and resets the marker.
  void finish(std::vector<GazeSample>& marked);

 private:
  /// Appends the samples of an ended movement.
  void take(const EyeMovement& movement, std::vector<GazeSample>& marked);

  EyeMovementDetector detector_;
  std::vector<GazeSample> waiting_;
};

/// Successive samples with one mark.
struct MarkedMovement {
  GazeMark mark = GazeMark::none;
  std::span<const GazeSample> samples;  ///< never none
  /// From its first sample to that of the next movement, or to its own last sample; not negative.
  Nanoseconds duration{0};
};

/// The movements of marked samples, in order; `samples` must outlive them.
std::vector<MarkedMovement> marked_movements(std::span<const GazeSample> samples);

}  // namespace foveola
