#include "study/simulation/virtual_preview.h"

#include <cmath>

#include "study/simulation/watched_participant.h"
#include "study/stage/trial_preview.h"

namespace foveola::study {
namespace {

MachineModel machine_for(const Protocol& protocol, const PlannedTrial& trial) {
  MachineModel machine = protocol.machine;
  if (trial.kind == TrialKind::catch_trial) {
    machine.samples_per_second = 0.0;
  }
  return machine;
}

}  // namespace

VirtualPreview::VirtualPreview(const SceneStage& stage, const Protocol& protocol,
                               const PlannedTrial& trial, const TrialSeeds& seeds,
                               Participant& participant,
                               const std::optional<GazeCorrection>& correction, VirtualClock& clock,
                               const Workers& workers)
    : machine_(machine_for(protocol, trial)),
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
  const double samples_per_frame = machine_.samples_per_second / machine_.frame_rate_hz;
  const auto samples_after = [&](std::uint64_t frames) {
    return static_cast<std::uint64_t>(std::floor(samples_per_frame * static_cast<double>(frames)));
  };
  const std::uint64_t samples = samples_after(frames_ + 1) - samples_after(frames_);
  const FrameReport report = preview_.render_frame(clock_.now(), samples);
  ++frames_;
  const Nanoseconds presented =
      start_ + nanoseconds_from_seconds(static_cast<double>(frames_) / machine_.frame_rate_hz);
  clock_.advance(presented - clock_.now());
  return report;
}

}  // namespace foveola::study
