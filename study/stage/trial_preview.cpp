#include "study/stage/trial_preview.h"

#include "renderer/view/equirect.h"

namespace foveola::study {

PreviewSettings trial_preview_settings(const Protocol& protocol, const TrialSettings& settings,
                                       const SceneStage& stage) {
  PreviewSettings preview;
  preview.film_width = settings.film.width;
  preview.film_height = settings.film.height;
  preview.view_width = protocol.display.view_width;
  preview.view_height = protocol.display.view_height;
  preview.horizontal_fov_deg = protocol.display.horizontal_fov_deg;
  preview.vertical_fov_deg = protocol.display.vertical_fov_deg;
  preview.lens = protocol.display.lens;
  preview.unsampled = settings.fill_unsampled ? UnsampledPixels::filled : UnsampledPixels::black;
  if (settings.film.adaptive_contrast > 0.0) {
    preview.adaptive = VisibleNoise{.contrast = settings.film.adaptive_contrast};
  }
  preview.viewpoint = stage.viewpoint();
  preview.exposure_stops = stage.source().exposure_stops;
  preview.trace.max_depth = settings.film.max_depth;
  preview.trace.pixel_angle_rad = pixel_angle_rad(preview.film_width);
  return preview;
}

double mark_timeout_s(const Protocol& protocol, const PlannedTrial& trial) {
  return trial.kind == TrialKind::catch_trial
             ? protocol.catch_trials.timeout_s
             : settings_of(protocol, trial.scene, trial.method).timing.mark_timeout_s;
}

}  // namespace foveola::study
