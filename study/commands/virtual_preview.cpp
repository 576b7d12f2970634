#include "study/commands/virtual_preview.h"

#include <cmath>

#include "renderer/view/equirect.h"
#include "study/commands/watched_participant.h"

namespace foveola::study {
namespace {

PreviewSettings settings_from(const Protocol& protocol, const SceneStage& stage) {
  PreviewSettings settings;
  settings.film_width = protocol.film.width;
  settings.film_height = protocol.film.height;
  settings.view_width = protocol.display.view_width;
  settings.view_height = protocol.display.view_height;
  settings.horizontal_fov_deg = protocol.display.horizontal_fov_deg;
  settings.vertical_fov_deg = protocol.display.vertical_fov_deg;
  settings.lens = protocol.display.lens;
  settings.unsampled =
      protocol.display.fill_unsampled ? UnsampledPixels::filled : UnsampledPixels::black;
  if (protocol.film.spare_done_contrast > 0.0) {
    settings.spare_done = VisibleNoise{.contrast = protocol.film.spare_done_contrast};
  }
  settings.viewpoint = stage.viewpoint();
  settings.exposure_stops = stage.source().exposure_stops;
  settings.trace.max_depth = protocol.film.max_depth;
  settings.trace.pixel_angle_rad = pixel_angle_rad(settings.film_width);
  return settings;
}

}  // namespace

VirtualPreview::VirtualPreview(const SceneStage& stage, const Protocol& protocol,
                               const std::string& method, const AttemptSeeds& seeds,
                               Participant& participant,
                               const std::optional<GazeCorrection>& correction, VirtualClock& clock,
                               const Workers& workers)
    : machine_(protocol.machine),
      clock_(clock),
      start_(clock.now()),
      eye_(watch(participant, protocol.tracker, seeds.tracker, correction)),
      head_([&participant](Nanoseconds time) { return participant.head(time); }),
      preview_(stage.tracer(), settings_from(protocol, stage), *eye_, head_, workers) {
  preview_.restart(make_sampler(protocol, method), seeds.rendering);
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
