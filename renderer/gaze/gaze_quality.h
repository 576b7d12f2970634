// How well and how regularly a tracker sees where the eye looks: accuracy, precision and loss of
// data, after Holmqvist, Nystrom and Mulvey 2012, "Eye tracker data quality: what it is and how to
// measure it"; rate and jitter.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/gaze/eye_tracker.h"

namespace foveola {

/// A target that the eye was asked to look at, and what the tracker saw meanwhile.
struct WatchedTarget {
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< unit length, head's axes
  Nanoseconds start{0};               ///< start of the time that counts
  Nanoseconds end{0};
  std::vector<GazeSample> samples;  ///< the samples of that time, in the order of their arrival
};

/// Figures of samples between saccades. They are true angles, so that both axes are in each.
struct GazeFigures {
  /// The mean angle between the samples and their target: that of the tracker's offset, if noise is
  /// small beside it; of noise alone, with deviation s along each axis, s sqrt(pi / 2).
  double accuracy_deg = 0.0;
  /// The root mean square angle between successive samples; of white noise 2 s.
  double precision_rms_deg = 0.0;
  /// The samples' root mean square angle to their mean direction; of noise sqrt(2) s.
  double precision_sd_deg = 0.0;
};

struct SeenTarget {
  Vec3 mean_gaze{0.0F, 0.0F, -1.0F};  ///< unit length, head's axes
  std::size_t samples = 0;            ///< how many samples the figures are of
  GazeFigures figures;
};

struct TargetQuality {
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< unit length, head's axes
  /// The part of the samples that came invalid or not at all, in [0, 1]. How many there should have
  /// been follows from the usual interval.
  double data_loss = 1.0;
  std::optional<SeenTarget> seen;  ///< empty if there were too few samples to judge
};

struct GazeQuality {
  std::vector<TargetQuality> targets;
  double data_loss = 1.0;  ///< the targets' mean
  /// The figures of all targets that were seen: the mean of accuracies, the root mean square of
  /// precisions.
  std::optional<GazeFigures> figures;
};

/// watched: at least one target. Saccades are left out by velocity (EyeMovementDetector): at 100
/// degrees per second, or at six times the median velocity if noise makes that the faster.
GazeQuality gaze_quality(std::span<const WatchedTarget> watched);

/// The limits of a quality that is good enough.
struct GazeGate {
  double max_accuracy_deg = 1.5;
  double max_precision_deg = 0.5;  ///< the largest precision_rms_deg that is accepted
  double max_data_loss = 0.3;
};

/// Whether every target was seen and the figures of all are within the gate.
bool passes(const GazeQuality& quality, const GazeGate& gate);

/// Looks at the samples of the last while, by their own times.
class InterSampleIntervals {
 public:
  /// Over how many intervals the figures below are taken.
  static constexpr std::size_t window = 240;

  /// Adds a sample unless it is older than the one before, or as old.
  void add(const GazeSample& sample);

  /// All so far.
  std::uint64_t samples() const { return samples_; }
  std::uint64_t valid_samples() const { return valid_samples_; }
  /// Intervals longer than one and a half times the usual one, so far: samples that never came.
  std::uint64_t gaps() const { return gaps_; }

  /// The reciprocal of the median interval; empty before two samples.
  std::optional<double> rate_hz() const;
  /// The intervals' mean absolute deviation from their median.
  std::optional<double> jitter_ms() const;

 private:
  std::optional<double> median_interval_s() const;

  std::optional<Nanoseconds> last_time_;
  std::deque<double> intervals_s_;
  std::uint64_t samples_ = 0;
  std::uint64_t valid_samples_ = 0;
  std::uint64_t gaps_ = 0;
};

}  // namespace foveola
