#include "study/stage/trial_preview.h"

#include <cmath>

namespace foveola::study {

PreviewSettings trial_preview_settings(const Protocol& protocol, const TrialSettings& settings,
                                       const SceneStage& stage) {
  PreviewSettings preview;
  preview.render.film_size = {settings.film.width, settings.film.height};
  preview.render.trace.max_depth = settings.film.max_depth;
  if (settings.film.adaptive_contrast > 0.0) {
    preview.render.adaptive = VisibleNoise{.contrast = settings.film.adaptive_contrast};
  }
  preview.render = stage.loaded().rendered_with(preview.render);
  preview.field_of_view = {.horizontal_deg = protocol.display.horizontal_fov_deg,
                           .vertical_deg = protocol.display.vertical_fov_deg,
                           .lens = protocol.display.lens};
  preview.view_size = {protocol.display.view_width, protocol.display.view_height};
  preview.unsampled = settings.fill_unsampled ? UnsampledPixels::filled : UnsampledPixels::black;
  preview.exposure_stops = stage.source().exposure_stops.value_or(0.0);
  preview.gaze_filter = protocol.tracker.filter;
  return preview;
}

bool is_rendered(const PlannedTrial& trial) { return trial.kind != TrialKind::catch_trial; }

std::uint64_t samples_after(std::uint64_t frames, const MachineModel& machine,
                            const PlannedTrial& trial) {
  const double per_frame =
      is_rendered(trial) ? machine.samples_per_second / machine.frame_rate_hz : 0.0;
  return static_cast<std::uint64_t>(std::floor(per_frame * static_cast<double>(frames)));
}

double mark_timeout_s(const Protocol& protocol, const PlannedTrial& trial) {
  return trial.kind == TrialKind::catch_trial
             ? protocol.catch_trials.timeout_s
             : settings_of(protocol, trial.scene, trial.method).timing.mark_timeout_s;
}

}  // namespace foveola::study
