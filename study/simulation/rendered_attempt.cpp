#include "study/simulation/rendered_attempt.h"

#include <algorithm>
#include <cmath>

#include "study/stage/conduct.h"

namespace foveola::study {
std::uint64_t frames_per_glance(const MachineModel& machine) {
  return static_cast<std::uint64_t>(
      std::max(1L, std::lround(glance_interval_s * machine.frame_rate_hz)));
}

RenderedAttempt::RenderedAttempt(const TrialAttemptSetting& setting, const Workers& workers)
    : setting_(setting),
      preview_(setting.stage, setting.protocol, setting.trial, setting.seeds, setting.participant,
               setting.correction, setting.clock, workers),
      log_(setting.recorder, setting.key) {}

std::optional<Nanoseconds> RenderedAttempt::show(Nanoseconds /*until*/) {
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

}  // namespace foveola::study
