// A recorded attempt shown again: its film is rendered from the recorded frames, and compared with
// the recorded hashes.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "renderer/gaze/eye_tracker.h"
#include "renderer/gaze/head_tracker.h"
#include "renderer/preview/preview.h"
#include "study/driver/ports.h"
#include "study/record/recorded_session.h"
#include "study/replay/replay.h"
#include "study/stage/scene_stage.h"

namespace foveola::study {

/// What is shown again; what is referred to must outlive the attempt.
struct AttemptReplaySetting {
  const SceneStage& stage;
  const Workers& workers;
  PreviewSettings preview;
  std::unique_ptr<ViewSampler> sampler;
  std::uint32_t seed = 0;  ///< the seed of the sample points and light paths
  RecordedFrames recorded;
  ReplayedAttempt attempt;        ///< which attempt it is
  std::filesystem::path picture;  ///< the file that gets its last view; empty: none
  /// What came of it, once all its frames are rendered.
  std::function<void(const ReplayedAttempt& attempt)> report;
};

class AttemptReplay final : public AttemptPort {
 public:
  explicit AttemptReplay(AttemptReplaySetting setting);

  /// The first time: returns when the first frame was presented, as far as that is recorded.
  Nanoseconds show(Nanoseconds until) override;
  /// Renders all its frames.
  void complete_record() override;
  std::uint64_t samples() const override { return preview_.film().total_samples(); }
  std::uint64_t non_finite() const override { return preview_.dropped().size(); }

 private:
  void render(const FrameRow& frame);
  void write_picture() const;

  AttemptReplaySetting setting_;
  // Nobody watches: where head and eye were is in the frames.
  FixedEyeTracker eye_{Vec3(0.0F, 0.0F, -1.0F)};
  SimulatedHeadTracker head_{[](Nanoseconds) { return AzimuthElevation{}; }};
  Preview preview_;
  std::optional<Nanoseconds> first_presented_;  ///< empty once it is shown
};

}  // namespace foveola::study
