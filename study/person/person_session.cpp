#include "study/person/person_session.h"

#include <fmt/format.h>

#include "renderer/preview/direct_panorama.h"
#include "study/console/console_words.h"
#include "study/person/pages.h"

namespace foveola::study {
namespace {

/// Sufficient to recognise an object, and rendered within a second.
constexpr IVec2 largest_panorama{2048, 1024};

IVec2 panorama_size(const FilmSettings& film) {
  return film.width <= largest_panorama.x ? IVec2(film.width, film.height) : largest_panorama;
}

template <typename Kind>
bool is(const Effect& effect) {
  return std::holds_alternative<Kind>(effect);
}

}  // namespace

PersonSession::PersonSession(const PersonSessionSettings& settings, const ShownStudy& study,
                             const Seat& seat, Console& console, SessionRecorder& recorder)
    : settings_(settings),
      study_(study),
      seat_(seat),
      told_plan_(settings.is_experimenter_blind ? without_methods(study.plan) : study.plan),
      console_(console),
      recorder_(recorder),
      zero_(seat.clock.now() - settings.position.time),
      clock_watch_(seat.read_clocks()),
      eye_(seat.tracker),
      prompt_{.reaction = ReactionPresses(Pcg32(derive_seed(
                  settings.seed, SeedPurpose::waiting, {settings.position.state.presses_left})))},
      viewer_(seat.pointer, seat.head),
      last_key_(settings.position.time),
      has_focus_(seat.has_focus),
      driver_({.protocol = study.protocol,
               .plan = study.plan,
               .position = settings.position,
               .notes = settings.notes},
              *this, *this, *this, recorder) {
  eye_.correct(settings.position.correction);
  viewer_.show(seat.display.geometry(), seat.display.framebuffer(), 1.0);
}

SessionOutcome PersonSession::run(const std::stop_token& stop) {
  // Lets other recordings of this machine be aligned with the session.
  console_.say(
      fmt::format("Session time 0 is {:.9f} s of this machine's monotonic clock.", seconds(zero_)));
  return driver_.run(stop);
}

void PersonSession::follow(const DurableEvent& durable) {
  const std::string words = words_for(durable.event, durable.after, study_.protocol);
  console_.tell({.time = durable.time,
                 .name = name_of(durable.event),
                 .phase = name_of(durable.after.phase),
                 .words = words});
  if (std::holds_alternative<Marked>(durable.event) ||
      std::holds_alternative<TimedOut>(durable.event)) {
    last_mark_ = words;
  }
  if (std::holds_alternative<Resumed>(durable.event)) {
    last_key_ = now();
  }
  study::follow(prompt_, durable.event, context());
  if (std::holds_alternative<GazeValidated>(durable.event)) {
    eye_.correct(driver_.correction());
  }
  if (!durable.effects.empty()) {
    end_confirmation();
  }
}

void PersonSession::carry_out(const Effect& effect) {
  prepare(prompt_, effect, context(), now());
  if (is<AskForObject>(effect) || is<AskWhetherReady>(effect)) {
    enter_scene();
    if (is<AskWhetherReady>(effect)) {
      viewer_.turn_to(chosen_object().direction, seat_.clock.now());
    }
  } else if (is<AskForRating>(effect)) {
    prompt_.look_around_until = driver_.look_around_until();
  } else if (is<StopRendering>(effect)) {
    prompt_.awaits_gaze = false;
    attempt_ = nullptr;
  } else if (is<EndSession>(effect) && driver_.seen().is_over()) {
    const Phase end = driver_.seen().phase;
    const bool can_be_undone = end == Phase::withdrawn || end == Phase::excluded;
    console_.say(
        fmt::format("The session is over. To close it, press Enter in the window or quit here{}.",
                    can_be_undone ? "; undo takes the end back" : ""));
  }
}

void PersonSession::enter_scene() {
  const std::string& scene = trial().scene;
  if (scene != scene_) {
    scene_ = scene;
    panorama_.reset();
    viewer_.look_along(stage().source().heading);
  }
  if (panorama_ == nullptr) {
    seat_.display.show_no_film();
    seat_.display.show({.screen = notice_screen(Notice::loading, study_.protocol.texts)});
    draw_panorama();
  }
  seat_.display.show_film(*panorama_, study_.workers);
}

const SceneStage& PersonSession::stage() const {
  const auto changed = changed_.find(trial().scene);
  return changed != changed_.end() ? *changed->second : *study_.stages.at(trial().scene);
}

void PersonSession::draw_panorama() {
  const IVec2 size = panorama_size(settings_of(study_.protocol, scene_, trial().method).film);
  panorama_ = std::make_unique<EquirectFilm>(size.x, size.y);
  show_direct_shading(stage().scene(), stage().tracer().ray_scene(), stage().viewpoint(),
                      *panorama_, study_.workers);
}

bool PersonSession::needs_gaze() const {
  // A simulated eye uses the planned contrast before every trial, even after lost attempts.
  const double adaptive_contrast =
      settings_of(study_.protocol, trial().scene, trial().method).film.adaptive_contrast;
  return seat_.simulated_operator == nullptr &&
         (follows_gaze(trial().method) || adaptive_contrast > 0.0);
}

std::unique_ptr<AttemptPort> PersonSession::begin_attempt() {
  if (needs_gaze() && !has_gaze()) {
    wait_for_gaze();
    return nullptr;
  }
  if (prompt_.awaits_gaze) {
    prompt_.awaits_gaze = false;
    page_watch_.turn_page();
  }
  if (needs_gaze()) {
    eye_.repeat_newest();
  }
  auto attempt = std::make_unique<LiveAttempt>(
      AttemptSetting{.protocol = study_.protocol,
                     .stage = stage(),
                     .workers = study_.workers,
                     .clock = seat_.clock,
                     .display = seat_.display,
                     .eye = eye_,
                     .head = viewer_.head(),
                     .recorder = recorder_,
                     .key = driver_.attempt_key(),
                     .trial = trial(),
                     .seed = rendering_seed(settings_.seed.seed, settings_.seed.design_row,
                                            study_.protocol, trial(), driver_.seen().timing),
                     .session_zero = zero_,
                     .while_waiting = [this] { answer_window(); },
                     .page = [this] { return page_of(prompt_, context(), now()); }});
  attempt_ = attempt.get();
  looking_times_ = {};
  figures_.begin_attempt();
  return attempt;
}

void PersonSession::wait_for_gaze() {
  if (prompt_.awaits_gaze) {
    return;
  }
  prompt_.awaits_gaze = true;
  driver_.record_event(NoteWritten{"the trial waits for a gaze"});
}

}  // namespace foveola::study
