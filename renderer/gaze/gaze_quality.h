// A tracker's data quality: accuracy, precision and data loss, after Holmqvist, Nystrom and Mulvey
// 2012, "Eye tracker data quality: what it is and how to measure it"; rate and jitter.
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

/// A target shown to the participant, and the tracker's samples meanwhile.
struct WatchedTarget {
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< unit length, head's axes
  Nanoseconds start{0};               ///< start of the counted time
  Nanoseconds end{0};
  std::vector<GazeSample> samples;  ///< the samples of that time, in order of arrival
};

/// Statistics of samples between saccades, as true angles over both axes.
struct GazeFigures {
  /// The mean angle between the samples and their target: the tracker's offset, if noise is small
  /// beside it; for noise alone, with deviation s along each axis, s sqrt(pi / 2).
  double accuracy_deg = 0.0;
  /// The root mean square angle between successive samples; for white noise 2 s.
  double precision_rms_deg = 0.0;
  /// The samples' root mean square angle to their mean direction; for noise sqrt(2) s.
  double precision_sd_deg = 0.0;
};

struct SeenTarget {
  Vec3 mean_gaze{0.0F, 0.0F, -1.0F};  ///< unit length, head's axes
  std::size_t samples = 0;            ///< number of samples
  GazeFigures figures;
};

struct TargetQuality {
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< unit length, head's axes
  /// Share of the samples that were invalid or missing, in [0, 1]. The expected number follows from
  /// the median interval.
  double data_loss = 1.0;
  std::optional<SeenTarget> seen;  ///< nullopt with too few samples
};

struct GazeQuality {
  std::vector<TargetQuality> targets;
  double data_loss = 1.0;  ///< the targets' mean
  /// Statistics over all targets with gaze: the mean of accuracies, the root mean square of
  /// precisions.
  std::optional<GazeFigures> figures;
};

/// watched: at least one target. Saccades are excluded by velocity (EyeMovementDetector): above 100
/// degrees per second, or above six times the median velocity if that is greater.
GazeQuality gaze_quality(std::span<const WatchedTarget> watched);

/// The limits of acceptable quality.
struct GazeGate {
  double max_accuracy_deg = 1.5;
  double max_precision_deg = 0.5;  ///< maximum precision_rms_deg
  double max_data_loss = 0.3;
};

/// Whether every target has gaze and the statistics are within the limits.
bool passes(const GazeQuality& quality, const GazeGate& gate);

/// Statistics of recent intervals between samples, by the samples' own times.
class InterSampleIntervals {
 public:
  /// Number of intervals in the statistics.
  static constexpr std::size_t window = 240;

  /// Adds a sample; ignores it unless it is newer than the last.
  void add(const GazeSample& sample);

  /// Totals so far.
  std::uint64_t samples() const { return samples_; }
  std::uint64_t valid_samples() const { return valid_samples_; }
  /// Number of intervals over one and a half times the median so far: missing samples.
  std::uint64_t gaps() const { return gaps_; }

  /// The reciprocal of the median interval; nullopt before two samples.
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
