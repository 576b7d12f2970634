#include "study/commands/rendered_attempt.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/film/film_hash.h"
#include "study/stage/conduct.h"

namespace foveola::study {
namespace {

AttemptSink attempt_sink(SessionSink& sink, std::size_t trial, int attempt) {
  return {.frames =
              [&sink, trial, attempt](std::uint64_t first, std::vector<FrameRow> frames) {
                sink.frames(trial, attempt, first, std::move(frames));
              },
          .gaze =
              [&sink, trial, attempt](std::uint64_t first, std::vector<GazeSample> samples) {
                sink.gaze(trial, attempt, first, std::move(samples));
              }};
}

}  // namespace

std::uint64_t frames_per_glance(const MachineModel& machine) {
  return static_cast<std::uint64_t>(
      std::max(1L, std::lround(glance_interval_s * machine.frame_rate_hz)));
}

RenderedAttempt::RenderedAttempt(const TrialAttemptSetting& setting, const Workers& workers)
    : setting_(setting),
      preview_(setting.stage, setting.protocol, setting.trial, setting.seeds, setting.participant,
               setting.correction, setting.clock, workers),
      log_(attempt_sink(setting.sink, setting.index, setting.number)) {}

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

void RenderedAttempt::keep() {
  log_.finish();
  if (log_.frames() > 0) {
    setting_.sink.film_hash(setting_.index, setting_.number,
                            {.frame = log_.frames() - 1, .sha256 = film_sha256(preview_.film())});
  }
}

}  // namespace foveola::study
