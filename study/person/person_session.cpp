#include "study/person/person_session.h"

#include <utility>

#include <fmt/format.h>

#include "renderer/preview/direct_panorama.h"
#include "study/person/console_words.h"
#include "study/person/pages.h"

namespace foveola::study {
namespace {

/// Enough to know an object by, and a second's work.
constexpr IVec2 largest_panorama{2048, 1024};

IVec2 panorama_size(const FilmSettings& film) {
  return film.width <= largest_panorama.x ? IVec2(film.width, film.height) : largest_panorama;
}

template <typename Kind>
bool is(const Effect& effect) {
  return std::holds_alternative<Kind>(effect);
}

}  // namespace

PersonSession::PersonSession(const PersonSessionSettings& settings, const Parts& parts)
    : settings_(settings),
      parts_(parts),
      zero_(parts.clock->now() - settings.time),
      log_(procedure_of(*parts.protocol, *parts.plan), settings.state, *parts.recorder),
      seen_(settings.state),
      prompt_{.reaction = ReactionPresses(Pcg32(derive_seed(settings.seed, SeedPurpose::waiting,
                                                            {settings.state.presses_left})))},
      viewer_(parts.pointer, parts.head) {
  parts_.eye->correct(settings.correction);
  viewer_.show(parts_.display->geometry(), parts_.display->framebuffer(), 1.0);
}

Phase PersonSession::run(const std::stop_token& stop) {
  begin();
  while (!is_done_) {
    show_frame();
    answer_window();
    for (const DurableEvent& durable : log_.take_durable()) {
      carry_out(durable);
    }
    if (stop.stop_requested()) {
      interrupt();
    } else {
      answer_console();
    }
  }
  return log_.state().phase;
}

void PersonSession::begin() {
  // By this, what else was recorded on the machine can be laid beside the session.
  parts_.tell(
      fmt::format("Session time 0 is {:.9f} s of this machine's monotonic clock.", seconds(zero_)));
  if (log_.state().phase == Phase::created) {
    feed(SessionStarted{});
    tell_of_amendment();
    return;
  }
  if (log_.state().phase != Phase::interrupted) {
    feed(Interrupted{});  // it died before it could say so
  }
  feed(NoteWritten{"goes on with " + settings_.devices});
  tell_of_amendment();
  feed(Resumed{});
}

void PersonSession::tell_of_amendment() {
  if (settings_.amendment) {
    feed(NoteWritten{*settings_.amendment});
  }
}

void PersonSession::interrupt() {
  is_done_ = true;
  for (const DurableEvent& durable : log_.wait_for_all()) {
    carry_out(durable);
  }
  feed(Interrupted{});
  for (const DurableEvent& durable : log_.wait_for_all()) {
    carry_out(durable);
  }
}

void PersonSession::carry_out(const DurableEvent& durable) {
  parts_.tell(fmt::format("{:9.3f} s  {}", seconds(durable.time), words_for(durable.event)));
  seen_ = durable.after;
  follow(prompt_, durable.event, context());
  if (const auto* validated = std::get_if<GazeValidated>(&durable.event)) {
    parts_.eye->correct(correction_after(*validated));
  }
  for (const Effect& effect : durable.effects) {
    carry_out(effect);
  }
  if (!durable.effects.empty()) {
    set_confirmation(std::nullopt);
  }
}

void PersonSession::carry_out(const Effect& effect) {
  prepare(prompt_, effect, context(), now());
  if (is<AskForObject>(effect) || is<AskWhetherReady>(effect)) {
    enter_scene();
  } else if (is<StartRendering>(effect)) {
    prepare_rendering();
  } else if (is<StopRendering>(effect)) {
    stop_rendering();
  } else if (is<EndSession>(effect) && seen_.is_over()) {
    parts_.tell("The session is over. Enter in the window, or quit here, closes it.");
  }
}

void PersonSession::enter_scene() {
  const std::string& scene = trial().scene;
  if (scene != scene_) {
    scene_ = scene;
    parts_.display->show_no_film();
    parts_.display->show({.screen = notice_screen(Notice::loading, parts_.protocol->texts)});
    viewer_.look_along(stage().source().heading);
    const IVec2 size = panorama_size(settings_of(*parts_.protocol, scene, trial().method).film);
    panorama_ = std::make_unique<EquirectFilm>(size.x, size.y);
    show_direct_shading(stage().scene(), stage().tracer().ray_scene(), stage().viewpoint(),
                        *panorama_, *parts_.workers);
  }
  parts_.display->show_film(*panorama_);
}

bool PersonSession::needs_gaze() const {
  // Whose eyes are simulated sits before every trial as it was planned, whatever is lost of them.
  const double adaptive_contrast =
      settings_of(*parts_.protocol, trial().scene, trial().method).film.adaptive_contrast;
  return parts_.simulated_operator == nullptr &&
         (follows_gaze(trial().method) || adaptive_contrast > 0.0);
}

void PersonSession::prepare_rendering() {
  if (needs_gaze() && !parts_.eye->has_gaze(parts_.clock->now())) {
    prompt_.awaits_gaze = true;
    feed(NoteWritten{"the trial waits for a gaze"});
    const std::string status = parts_.eye->status();
    parts_.tell(fmt::format(
        "The trial does not begin: {}. It begins by itself once there is a valid gaze; no time "
        "runs until then.",
        !status.empty()             ? status
        : parts_.pointer != nullptr ? "the pointer, which is the eye here, is not in the window"
                                    : "the eye tracker does not see the eyes"));
    return;
  }
  if (needs_gaze()) {
    parts_.eye->repeat_newest();
  }
  start_rendering();
}

void PersonSession::start_rendering() {
  attempt_ = std::make_unique<LiveAttempt>(
      AttemptSetting{.protocol = parts_.protocol,
                     .stage = &stage(),
                     .workers = parts_.workers,
                     .clock = parts_.clock,
                     .display = parts_.display,
                     .eye = parts_.eye,
                     .head = &viewer_.head(),
                     .recorder = parts_.recorder,
                     .key = {.trial = *trial_of(log_.procedure(), seen_), .attempt = seen_.attempt},
                     .trial = trial(),
                     .seed = rendering_seed(settings_.seed.seed, settings_.seed.design_row,
                                            *parts_.protocol, trial(), seen_.timing),
                     .session_zero = zero_,
                     .while_waiting = [this] { answer_window(); },
                     .page = [this] { return page_of(prompt_, context(), now()); }});
}

void PersonSession::stop_rendering() {
  prompt_.awaits_gaze = false;
  // There is none if it was another program's, which died.
  if (attempt_) {
    attempt_->finish();
    samples_ += attempt_->samples();
    non_finite_ += attempt_->non_finite();
    attempt_.reset();
  }
}

}  // namespace foveola::study
