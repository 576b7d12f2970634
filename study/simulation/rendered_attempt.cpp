#include "study/simulation/rendered_attempt.h"

#include <algorithm>
#include <cmath>

#include "study/participant/conduct.h"
#include "study/simulation/gaze_validation.h"
#include "study/stage/trial_preview.h"

namespace foveola::study {

std::uint64_t frames_per_glance(const MachineModel& machine) {
  return static_cast<std::uint64_t>(
      std::max(1L, std::lround(glance_interval_s * machine.frame_rate_hz)));
}

RenderedAttempt::RenderedAttempt(const TrialAttemptSetting& setting, const Workers& workers)
    : TrialAttempt(setting),
      preview_(setting.stage, setting.protocol, setting.trial, setting.seeds, setting.participant,
               setting.correction, setting.clock, workers),
      log_(setting.recorder, setting.key) {}

std::optional<Nanoseconds> RenderedAttempt::show_frames(Nanoseconds /*until*/) {
  const bool is_glance = log_.frames() % frames_per_glance(setting_.protocol.machine) == 0;
  render_frame();
  if (!is_glance) {
    return std::nullopt;
  }
  const Nanoseconds now = setting_.clock.now();
  return setting_.participant.see({.image = preview_.present(),
                                   .viewport = preview_.viewport(),
                                   .gaze = setting_.participant.gaze(now),
                                   .presented = now});
}

void RenderedAttempt::render_frame() {
  FrameRow row = frame_row(preview_.next_frame());
  row.time += setting_.attempt_start;
  row.presented = setting_.attempt_start + setting_.clock.now();
  std::vector<GazeSample> arrived = preview_.arrived_gaze();
  for (GazeSample& sample : arrived) {
    sample.time += setting_.attempt_start;
  }
  log_.add(row, arrived);
}

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
