#include "study/stage/trial_preview.h"

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
  preview.exposure_stops = stage.source().exposure_stops;
  return preview;
}

double mark_timeout_s(const Protocol& protocol, const PlannedTrial& trial) {
  return trial.kind == TrialKind::catch_trial
             ? protocol.catch_trials.timeout_s
             : settings_of(protocol, trial.scene, trial.method).timing.mark_timeout_s;
}

}  // namespace foveola::study
