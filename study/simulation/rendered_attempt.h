// An attempt whose every frame is rendered and seen, on the clock of a machine model: slow, but
// nothing is predicted.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/gaze/calibration.h"
#include "renderer/preview/preview.h"
#include "study/participant/participant.h"
#include "study/protocol/protocol.h"
#include "study/simulation/trial_attempt.h"
#include "study/stage/attempt_log.h"
#include "study/stage/scene_stage.h"

namespace foveola::study {

/// One attempt's rendering, watched by `participant` through the protocol's eye tracker, corrected
/// if its calibration says so, and a simulated head tracker; nothing is traced in a catch trial. It
/// refers to everything it is made of and advances `clock`, the attempt's, by a frame's time a
/// frame.
class VirtualPreview {
 public:
  VirtualPreview(const SceneStage& stage, const Protocol& protocol, const PlannedTrial& trial,
                 const TrialSeeds& seeds, Participant& participant,
                 const std::optional<GazeCorrection>& correction, VirtualClock& clock,
                 const Workers& workers);

  /// Renders the next frame; when it returns, the clock shows when that frame is presented.
  FrameReport next_frame();

  /// What is on the display now, and the view that it was rendered for.
  const RgbImage& present() { return preview_.present(); }
  const Viewport& viewport() const { return preview_.viewport(); }
  const std::vector<GazeSample>& arrived_gaze() const { return preview_.arrived_gaze(); }
  const EquirectFilm& film() const { return preview_.film(); }
  std::uint64_t non_finite() const { return preview_.dropped().size(); }

 private:
  const MachineModel& machine_;
  const PlannedTrial& trial_;
  VirtualClock& clock_;
  Nanoseconds start_;
  std::uint64_t frames_ = 0;
  std::unique_ptr<EyeTracker> eye_;
  SimulatedHeadTracker head_;
  Preview preview_;
};

class RenderedAttempt final : public TrialAttempt {
 public:
  RenderedAttempt(const TrialAttemptSetting& setting, const Workers& workers);

  void complete_record() override { log_.finish(preview_.film()); }
  std::uint64_t samples() const override { return preview_.film().total_samples(); }
  std::uint64_t non_finite() const override { return preview_.non_finite(); }

 private:
  std::optional<Nanoseconds> show_frames(Nanoseconds until) override;
  /// Renders the next frame into the record; when it returns, it is presented.
  void render_frame();

  VirtualPreview preview_;
  AttemptLog log_;
};

}  // namespace foveola::study
