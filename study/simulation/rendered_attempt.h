// An attempt whose every frame is rendered and seen: slow, but nothing is predicted.
#pragma once

#include "study/simulation/trial_attempt.h"
#include "study/simulation/virtual_preview.h"
#include "study/stage/attempt_log.h"

namespace foveola::study {

class RenderedAttempt final : public TrialAttempt {
 public:
  RenderedAttempt(const TrialAttemptSetting& setting, const Workers& workers);

  std::optional<Nanoseconds> show(Nanoseconds until) override;
  void begin(Task /*task*/) override {}
  void complete_record() override { log_.finish(preview_.film()); }
  std::uint64_t samples() const override { return preview_.film().total_samples(); }
  std::uint64_t non_finite() const override { return preview_.non_finite(); }

 private:
  /// Renders the next frame into the record; when it returns, it is presented.
  void render_frame();

  TrialAttemptSetting setting_;
  VirtualPreview preview_;
  AttemptLog log_;
};

}  // namespace foveola::study
