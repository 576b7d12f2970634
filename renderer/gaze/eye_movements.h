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
  Vec3 from{0.0F, 0.0F, -1.0F};    ///< the direction at its start
  Vec3 to{0.0F, 0.0F, -1.0F};      ///< the gaze at its end; without data both are meaningless
  double fastest_deg_per_s = 0.0;  ///< the largest velocity between its samples
};

struct EyeMovementSettings {
  /// Faster is a saccade (100 degrees per second: Salvucci and Goldberg 2000). Noise must stay well
  /// below it: samples at 120 Hz that scatter by 0.1 degrees along each axis seem to move at more
  /// than 30 degrees per second a fifth of the time.
  double threshold_deg_per_s = 100.0;
  /// What is shorter belongs to the movement around it: about one sample at 120 Hz, and the
  /// shortest time between two saccades (both assumed).
  Nanoseconds shortest_saccade = std::chrono::milliseconds(8);
  Nanoseconds shortest_fixation = std::chrono::milliseconds(60);
  /// Up to so long between two valid samples, the eye is taken to have moved steadily; beyond,
  /// there is no data (assumed: the shortest blink lasts longer).
  Nanoseconds longest_interval = std::chrono::milliseconds(75);
};

/// Identification by a velocity threshold (I-VT, Salvucci and Goldberg 2000), sample by sample. The
/// velocity is the true angle between two successive valid samples over the time between them.
/// Movements follow each other without a gap; the first of all, and the first after a time without
/// data, may be shorter than the shortest.
class EyeMovementDetector {
 public:
  explicit EyeMovementDetector(const EyeMovementSettings& settings) : settings_(settings) {}

  /// Adds the stream's next sample and returns the movements that are now known to be over: up to
  /// two, in the order of time. A sample that is not later than the one before is passed over.
  std::vector<EyeMovement> push(const GazeSample& sample);
  /// What was going on up to the last sample, if anything. The detector is then as new.
  std::optional<EyeMovement> finish();

  /// What the newest two valid samples say, before it is known for how long; no data if the newest
  /// sample of all is invalid, or stands alone.
  EyeMovementKind now() const { return now_; }

 private:
  /// After the last valid sample nothing is known.
  void begin_no_data(std::vector<EyeMovement>& over);
  /// Adds the movement between two successive valid samples.
  void add(const EyeMovement& step, std::vector<EyeMovement>& over);
  EyeMovement step_to(const GazeSample& sample) const;
  Nanoseconds shortest(EyeMovementKind kind) const;
  /// Ends what is going on, and what was too short to be anything else with it.
  std::optional<EyeMovement> take_going_on();

  EyeMovementSettings settings_;
  EyeMovementKind now_ = EyeMovementKind::no_data;
  std::optional<Nanoseconds> last_time_;
  std::optional<GazeSample> last_valid_;  ///< where the next step begins; empty without data
  std::optional<EyeMovement> going_on_;
  std::optional<EyeMovement> beginning_;  ///< a movement of the other kind that is still too short
};

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
