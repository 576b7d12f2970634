// Latency from the eye's movement to the light of the frame that reflects it: the budget of Koskela
// et al. 2018, figure 7.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace foveola {

enum class Provenance {
  measured,  ///< measured on this device
  assumed    ///< from a data sheet, a publication or by guess
};

struct KnownDuration {
  double duration_s = 0.0;  ///< >= 0
  Provenance provenance = Provenance::assumed;
};

/// The components of the budget. Rates are positive.
struct LatencyInputs {
  double tracker_rate_hz = 0.0;
  KnownDuration exposure;  ///< exposure time of one of the tracker's images
  KnownDuration transfer;
  KnownDuration processing;
  KnownDuration frame_interval;  ///< from one poll of the gaze to the next
  std::optional<KnownDuration>
      waiting;  ///< the gaze's waiting time in a particular frame, if known
  KnownDuration tracing;
  KnownDuration film_and_resample;
  KnownDuration present;   ///< presentation, including the wait for the display's next refresh
  KnownDuration scan_out;  ///< until all of the frame is lit
};

struct LatencyStage {
  std::string_view name;
  double best_s = 0.0;
  double worst_s = 0.0;
  Provenance provenance = Provenance::assumed;
};

using LatencyStages = std::array<LatencyStage, 8>;

/// The stages in the order of time. An image shows the eye as in the middle of its exposure, so:
///
/// - exposure: at best the eye has moved just before the middle, and half of it is left; at worst
///   just after, and the next image, 1 / tracker_rate_hz later, is the first to show it;
/// - waiting for the frame: at best the gaze arrives as a frame looks at it; at worst just after,
///   and waits for a whole frame interval; in a certain frame, as long as it waited;
/// - all others take what they take.
///
/// FOVE 0 with frames of 14 ms: at best 4 + 2 + 4 + 0 + 14 + 14 = 38 ms, as published, and at worst
/// 12.3 + 2 + 4 + 14 + 14 + 14 = 60.3 ms.
LatencyStages latency_stages(const LatencyInputs& inputs);

/// Sums over `stages`; measured only if all of them are.
LatencyStage total_latency(std::span<const LatencyStage> stages);

/// A stage's durations over many frames.
struct LatencySpread {
  std::string_view name;
  double best_s = 0.0;  ///< minimum over all frames
  double median_s = 0.0;
  double percentile_95_s = 0.0;
  double worst_s = 0.0;
  Provenance provenance = Provenance::assumed;  ///< measured if it is in every frame
};

struct LatencyReport {
  std::array<LatencySpread, 8> stages;
  LatencySpread total;  ///< spread of the frames' totals, not the sum of the stages' spreads
};

/// frames: at least one. Between a frame's best and worst case every latency is equally likely,
/// since the eye moves at any moment: median and percentile are over frames and moments.
LatencyReport latency_report(std::span<const LatencyStages> frames);

}  // namespace foveola
