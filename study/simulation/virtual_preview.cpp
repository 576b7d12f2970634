#include "study/simulation/virtual_preview.h"

#include "study/simulation/watched_participant.h"
#include "study/stage/trial_preview.h"

namespace foveola::study {

VirtualPreview::VirtualPreview(const SceneStage& stage, const Protocol& protocol,
                               const PlannedTrial& trial, const TrialSeeds& seeds,
                               Participant& participant,
                               const std::optional<GazeCorrection>& correction, VirtualClock& clock,
                               const Workers& workers)
    : machine_(protocol.machine),
      trial_(trial),
      clock_(clock),
      start_(clock.now()),
      eye_(watch(participant, protocol.tracker, seeds.tracker, correction)),
      head_([&participant](Nanoseconds time) { return participant.head(time); }),
      preview_(
          stage.tracer(),
          trial_preview_settings(protocol, settings_of(protocol, trial.scene, trial.method), stage),
          *eye_, head_, workers) {
  preview_.restart(make_sampler(protocol, trial.method), seeds.rendering);
}

FrameReport VirtualPreview::next_frame() {
  const std::uint64_t samples =
      samples_after(frames_ + 1, machine_, trial_) - samples_after(frames_, machine_, trial_);
  const FrameReport report = preview_.render_frame(clock_.now(), samples);
  ++frames_;
  const Nanoseconds presented =
      start_ + nanoseconds_from_seconds(static_cast<double>(frames_) / machine_.frame_rate_hz);
  clock_.advance(presented - clock_.now());
  return report;
}

}  // namespace foveola::study
