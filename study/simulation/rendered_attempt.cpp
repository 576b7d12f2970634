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
      start_(setting.clock.now()),
      eye_(watch(setting.participant, setting.protocol.tracker, setting.seeds.tracker,
                 setting.correction)),
      head_([&participant = setting.participant](Nanoseconds time) {
        return participant.head(time);
      }),
      preview_(setting.stage.tracer(),
               trial_preview_settings(
                   setting.protocol,
                   settings_of(setting.protocol, setting.trial.scene, setting.trial.method),
                   setting.stage),
               *eye_, head_, workers),
      log_(setting.recorder, setting.key) {
  preview_.restart(make_sampler(setting.protocol, setting.trial.method), setting.seeds.rendering);
}

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
  const MachineModel& machine = setting_.protocol.machine;
  const std::uint64_t samples = samples_after(frames_ + 1, machine, setting_.trial) -
                                samples_after(frames_, machine, setting_.trial);
  FrameRow row = frame_row(preview_.render_frame(setting_.clock.now(), samples));
  ++frames_;
  const Nanoseconds presented =
      start_ + nanoseconds_from_seconds(static_cast<double>(frames_) / machine.frame_rate_hz);
  setting_.clock.advance(presented - setting_.clock.now());
  row.time += setting_.attempt_start;
  row.presented = setting_.attempt_start + presented;
  std::vector<GazeSample> arrived = preview_.arrived_gaze();
  for (GazeSample& sample : arrived) {
    sample.time += setting_.attempt_start;
  }
  log_.add(row, arrived);
}

}  // namespace foveola::study
