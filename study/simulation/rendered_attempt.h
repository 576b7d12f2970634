// Simulates an attempt by rendering every frame, on the clock of a machine model. Slower than
// PredictedAttempt, but exact.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "renderer/gaze/calibration.h"
#include "renderer/preview/preview.h"
#include "study/simulation/trial_attempt.h"
#include "study/stage/attempt_log.h"

namespace foveola::study {

/// The simulated participant's gaze passes through the protocol's eye tracker, with the
/// calibration's correction if there is one; the head through a simulated head tracker. A catch
/// trial renders nothing. The attempt's clock advances by the machine model's frame time after each
/// frame.
class RenderedAttempt final : public TrialAttempt {
 public:
  /// The references in `setting`, and workers, must outlive it.
  RenderedAttempt(const TrialAttemptSetting& setting, const Workers& workers);

  void complete_record() override { log_.finish(preview_.film()); }
  std::uint64_t samples() const override { return preview_.film().total_samples(); }
  std::uint64_t non_finite() const override { return preview_.dropped().size(); }

 private:
  std::optional<Nanoseconds> show_frames(Nanoseconds until) override;
  /// Renders the next frame into the record. On return it is presented.
  void render_frame();

  Nanoseconds start_;
  std::uint64_t frames_ = 0;
  std::unique_ptr<EyeTracker> eye_;
  SimulatedHeadTracker head_;
  Preview preview_;
  AttemptLog log_;
};

}  // namespace foveola::study
