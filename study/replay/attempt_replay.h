// Replays a recorded attempt: renders its film from the recorded frames, and compares it with the
// recorded hashes.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/head_tracker.h"
#include "renderer/preview/preview.h"
#include "study/driver/ports.h"
#include "study/record/read/recorded_session.h"
#include "study/replay/replay.h"
#include "study/stage/scene_stage.h"

namespace foveola::study {

/// Inputs of a replayed attempt; everything referred to must outlive it.
struct AttemptReplaySetting {
  const SceneStage& stage;
  const Workers& workers;
  PreviewSettings preview;
  std::unique_ptr<ViewSampler> sampler;
  std::uint32_t seed = 0;  ///< the seed of the sample points and light paths
  RecordedFrames recorded;
  ReplayedAttempt attempt;        ///< identifies the attempt
  std::filesystem::path picture;  ///< file for its last view; empty: none
  /// Receives the result once all frames are rendered.
  std::function<void(const ReplayedAttempt& attempt)> report;
};

class AttemptReplay final : public AttemptPort {
 public:
  explicit AttemptReplay(AttemptReplaySetting setting);

  /// The first call returns the time of the first presented frame, as far as that is recorded.
  Nanoseconds show(Nanoseconds until) override;
  /// Renders all its frames.
  void complete_record() override;
  std::uint64_t samples() const override { return preview_.film().total_samples(); }
  std::uint64_t non_finite() const override { return preview_.dropped().size(); }

 private:
  void render(const FrameRow& frame);
  void write_picture() const;

  AttemptReplaySetting setting_;
  // A placeholder: head and eye are in the recorded frames.
  FixedEyeTracker eye_{Vec3(0.0F, 0.0F, -1.0F)};
  SimulatedHeadTracker head_{[](Nanoseconds) { return AzimuthElevation{}; }};
  Preview preview_;
  std::optional<Nanoseconds> first_presented_;  ///< empty once it was returned
};

}  // namespace foveola::study
