#include "study/person/session/person_session.h"

#include <utility>

#include <fmt/format.h>

#include "renderer/preview/direct_panorama.h"
#include "study/console/console_words.h"
#include "study/person/prompts/pages.h"
#include "study/stage/offered_object.h"
#include "study/stage/trial_preview.h"

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

/// A larger share than this counts as most of a trial.
constexpr double most = 0.5;

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

// Checks of whether the participant looks at the trial's object, and their consequences.

const OfferedObject& PersonSession::chosen_object() const {
  return object_named(stage().objects(), driver_.seen().object);
}

void PersonSession::watch_gaze(Nanoseconds shown) {
  if (attempt_ == nullptr) {
    return;
  }
  const Nanoseconds before = std::exchange(watched_until_, shown);
  if (driver_.seen().phase != Phase::marking) {
    return;
  }
  looking_times_.add(attempt_->newest_frame(), shown - before, chosen_object());
}

void PersonSession::judge_mark() {
  if (attempt_ == nullptr || !is_rendered(trial())) {
    return;
  }
  const OfferedObject& object = chosen_object();
  const ObjectSight sight = object_sight(attempt_->viewport(), object);
  if (!sight.is_in_view) {
    const std::string& mark = study_.protocol.marks[driver_.state().mark - 1].id;
    follow_up(
        fmt::format("{} was marked while the object, {}, was out of view, {:.0f} degrees from "
                    "its middle",
                    mark, object.name, sight.from_middle_deg),
        study_.protocol.looking.object_out_of_view, TimedAgain::object_out_of_view);
  }
  if (driver_.state().phase == Phase::rating) {
    judge_gaze();
  }
}

void PersonSession::judge_gaze() {
  // Participants have no reason to move the pointer where no method follows it.
  if (seat_.pointer != nullptr && !needs_gaze()) {
    return;
  }
  if (looking_times_.part_elsewhere() > most) {
    follow_up(fmt::format("the gaze was not on the object, {}, for {:.0f} % of the time until the "
                          "last mark",
                          chosen_object().name, 100.0 * looking_times_.part_elsewhere()),
              study_.protocol.looking.gaze_elsewhere, TimedAgain::gaze_elsewhere);
  } else if (needs_gaze() && looking_times_.part_unknown() > most) {
    follow_up(fmt::format("there was no valid gaze for {:.0f} % of the time until the last mark",
                          100.0 * looking_times_.part_unknown()),
              Remedy::flag, TimedAgain::no);
  }
}

void PersonSession::follow_up(const std::string& finding, Remedy remedy, TimedAgain reason) {
  const bool is_timed_again = remedy == Remedy::retime && driver_.state().timing <= max_retimings;
  driver_.record_event(NoteWritten{finding + (is_timed_again ? "; the trial is retimed" : "")});
  if (is_timed_again) {
    prompt_.timed_again = reason;
    driver_.record_event(RetimeRequested{});
  }
}

// Status lines of a person's session for the experimenter.

void PersonSession::count_frame(Nanoseconds shown) {
  if (attempt_ == nullptr) {
    figures_.add_frame(shown, arrived_);
    return;
  }
  figures_.add_attempt_frame(attempt_->newest_frame().is_late);
  figures_.add_frame(shown, attempt_->arrived_gaze());
  if (!slow_drawing_) {
    slow_drawing_ = attempt_->slow_drawing();
  }
}

void PersonSession::show_status() {
  waits_for_disk_since_ = driver_.has_effects_to_come()
                              ? std::optional(waits_for_disk_since_.value_or(now()))
                              : std::nullopt;
  constexpr Nanoseconds interval = std::chrono::milliseconds(250);
  if (!status_shown_ || now() - *status_shown_ >= interval) {
    status_shown_ = now();
    console_.show(status());
  }
}

SessionStatus PersonSession::status() const {
  const SessionState& seen = driver_.seen();
  return {.participant = settings_.participant,
          .time = now(),
          .is_paused = seen.phase == Phase::paused,
          .now = words_for(seen, driver_.procedure(), told_plan_),
          .then = words_for_next(seen, driver_.procedure(), told_plan_),
          .next_key = words_for_next_key(prompt_, context(), now()),
          .frames = figures_.frames(seat_.display.refresh().rate_hz()),
          .gaze = figures_.gaze(settings_.eye, seat_.clock.now()),
          .last_mark = last_mark_,
          .warnings = warnings()};
}

std::vector<StatusWarning> PersonSession::warnings() const {
  std::vector<StatusWarning> all;
  if (!has_focus_) {
    all.push_back({WarningKind::no_focus, no_focus_line});
  }
  const Phase phase = driver_.seen().phase;
  const bool is_waited_for = phase != Phase::paused && !driver_.seen().is_over();
  if (std::optional<StatusWarning> idle = warning_of(now() - last_key_); idle && is_waited_for) {
    all.push_back(std::move(*idle));
  }
  const std::string tracker = eye_.status();
  if (prompt_.awaits_gaze) {
    all.push_back(
        {WarningKind::awaits_gaze,
         fmt::format("The trial does not begin: {}. It begins by itself once there is valid "
                     "gaze; no time runs until then.",
                     !tracker.empty()           ? tracker
                     : seat_.pointer != nullptr ? "the pointer, which is the eye here, is not in "
                                                  "the window"
                                                : "the eye tracker does not see the eyes")});
  }
  if (was_lost_) {
    all.push_back(
        {WarningKind::no_gaze,
         fmt::format("The eye tracker sends no gaze{}{}. The session continues; pause it if "
                     "it should wait.",
                     tracker.empty() ? "" : ": ", tracker)});
  }
  if (std::optional<StatusWarning> late =
          warning_of(figures_.frames(seat_.display.refresh().rate_hz()))) {
    all.push_back(std::move(*late));
  }
  if (slow_drawing_) {
    all.push_back({WarningKind::slow_drawing, slow_drawing_line(*slow_drawing_)});
  }
  constexpr Nanoseconds longest_commit = std::chrono::seconds(2);
  if (waits_for_disk_since_ && now() - *waits_for_disk_since_ > longest_commit) {
    all.push_back(
        {WarningKind::slow_record,
         "The study's file cannot be written: another program has locked it, or the disk is "
         "slow. The session waits for up to a minute; close that program."});
  }
  return all;
}

}  // namespace foveola::study
