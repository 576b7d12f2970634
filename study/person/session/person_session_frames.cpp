// Frames of a person's session.
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "study/person/prompts/pages.h"
#include "study/person/session/object_pick.h"
#include "study/person/session/person_session.h"

namespace foveola::study {
namespace {

constexpr Vec3 forward{0.0F, 0.0F, -1.0F};

RgbImage cut(RgbImage window, const WindowPart& part) {
  if (part.size == IVec2(window.width, window.height)) {
    return window;
  }
  RgbImage image(part.size.x, part.size.y);
  const int top = window.height - part.origin.y - part.size.y;
  for (int y = 0; y < part.size.y; ++y) {
    std::copy_n(&window.at(part.origin.x, top + y), part.size.x, &image.at(0, y));
  }
  return image;
}

}  // namespace

void PersonSession::begin_frame() {
  follow_changes();
  const std::optional<int> number = page_watch_.picture_due(!driver_.has_effects_to_come());
  if (number && settings_.screens) {
    seat_.display.take_picture(*settings_.screens /
                               fmt::format("{:03}-{}.png", *number, name_of(driver_.seen().phase)));
  }
  prompt_.reaction.begin_frame(seat_.clock.now());
  if (seat_.simulated_operator != nullptr && attempt_ != nullptr &&
      seat_.simulated_operator->wants_to_look()) {
    seat_.display.keep_pixels();
  }
}

void PersonSession::follow_changes() {
  if (study_.reloader == nullptr) {
    return;
  }
  if (attempt_ != nullptr) {
    attempt_->give_way(study_.reloader->is_loading());
  }
  std::optional<ReloadedStage> reloaded = study_.reloader->take_reloaded();
  if (!reloaded) {
    return;
  }
  std::string note;
  if (reloaded->stage == nullptr) {
    note =
        fmt::format("the changed scene {} cannot be shown: {}", reloaded->scene, reloaded->refusal);
  } else {
    note = fmt::format("the scene {} has changed; from here on its SHA-256 is {}", reloaded->scene,
                       reloaded->stage->scene().sha256);
    replace_scene_stage(reloaded->scene, std::move(reloaded->stage));
  }
  driver_.record_event(NoteWritten{note});
}

/// Replaces the stage of `scene`. Keeps view, method and gaze; a running attempt continues with an
/// empty film.
void PersonSession::replace_scene_stage(const std::string& scene,
                                        std::unique_ptr<const SceneStage> stage) {
  // Keeps the former stage alive: attempt and display refer to it until this function ends.
  const auto former = std::exchange(changed_[scene], std::move(stage));
  if (scene != scene_) {
    return;
  }
  if (attempt_ != nullptr) {
    attempt_->show_scene(*changed_[scene]);
  } else {
    seat_.display.show_no_film();
  }
  panorama_.reset();  // it shows the former scene
  if (is_picture_shown()) {
    page_watch_.turn_page();
  }
  const Phase phase = driver_.seen().phase;
  if (phase == Phase::choosing_object || phase == Phase::ready || prompt_.awaits_gaze) {
    enter_scene();
  }
}

Nanoseconds PersonSession::show() {
  const Nanoseconds shown = seat_.display.show(picture());
  arrived_.clear();
  eye_.poll(seat_.clock.now(), arrived_);
  return shown - zero_;
}

void PersonSession::end_frame(Nanoseconds shown) {
  const Nanoseconds shown_by_clock = shown + zero_;
  page_watch_.was_shown(shown_by_clock);
  if (is_form_shown(prompt_, driver_.seen().phase)) {
    prompt_.form->was_shown(shown_by_clock);
  } else if (prompt_.form) {
    prompt_.form->was_hidden();
  }
  note_tracker();
  watch_gaze(shown);
  count_frame(shown);
  show_status();
  if (seat_.simulated_operator != nullptr) {
    show_to_operator(shown_by_clock);
  }
  continue_after_frame(shown_by_clock);
}

void PersonSession::show_to_operator(Nanoseconds shown) {
  const bool is_in_trial = trial_of(driver_.procedure(), driver_.seen()).has_value();
  seat_.simulated_operator->follow({.prompt = prompt_,
                                    .context = context(),
                                    .offered = is_in_trial ? &stage().objects() : nullptr,
                                    .shown = shown,
                                    .session_time = now(),
                                    .pixels = take_pixels()},
                                   !driver_.has_effects_to_come());
}

std::optional<ShownPixels> PersonSession::take_pixels() {
  std::optional<RgbImage> pixels = seat_.display.take_pixels();
  if (!pixels || attempt_ == nullptr) {
    return std::nullopt;
  }
  return ShownPixels{.image = cut(std::move(*pixels), seat_.display.geometry().parts.front()),
                     .viewport = attempt_->viewport()};
}

void PersonSession::continue_after_frame(Nanoseconds shown) {
  if (driver_.waits_in(Phase::validation)) {
    go_on_validating();
  } else if (driver_.waits_in(Phase::reaction)) {
    go_on_reacting(shown);
  } else if (driver_.waits_in(Phase::rating) && begin_rating(prompt_, study_.protocol, now())) {
    prompt_.looked_around = now() - driver_.seen().last_mark;
    if (attempt_ != nullptr) {
      attempt_->begin_rating(
          settings_of(study_.protocol, trial().scene, trial().method).timing.while_rating);
    }
    page_watch_.turn_page();
  }
}

void PersonSession::go_on_validating() {
  if (!prompt_.validation) {
    return;
  }
  prompt_.validation->update(seat_.clock.now(), arrived_);
  if (prompt_.validation->result()) {
    driver_.record_event(*prompt_.validation->result());
    prompt_.validation.reset();
  }
}

void PersonSession::go_on_reacting(Nanoseconds shown) {
  if (!prompt_.notices.empty()) {
    return;
  }
  if (const auto pressed = prompt_.reaction.end_frame(*study_.protocol.reaction, shown)) {
    driver_.record_event(
        ReactionPressed{.shown = pressed->shown - zero_, .time = pressed->time - zero_});
  }
}

SessionPicture PersonSession::picture() {
  SessionPicture picture{.head = viewer_.orientation(seat_.clock.now())};
  if (driver_.seen().phase == Phase::validation && prompt_.validation) {
    picture.overlays.target = picture.head * prompt_.validation->target().value_or(forward);
  } else if (driver_.seen().phase == Phase::choosing_object) {
    const std::size_t ahead = object_ahead_now();
    picture.overlays.offers = rings_of(stage().objects(), ahead);
    show_object(stage().objects()[ahead], picture.head);
  } else if (driver_.seen().phase == Phase::ready) {
    picture.overlays.offers = {ring_of(chosen_object())};
    show_object(chosen_object(), picture.head);
  }
  picture.screen = page_of(prompt_, context(), now());
  return picture;
}

void PersonSession::show_object(const OfferedObject& object, const Quat& head) {
  const Viewport view = viewports_of(seat_.display.geometry(), head).front();
  prompt_.object = {.name = object.name, .is_in_view = object_sight(view, object).is_in_view};
}

std::size_t PersonSession::object_ahead_now() {
  const Quat head = viewer_.orientation(seat_.clock.now());
  return object_ahead(stage().objects(), head * forward);
}

}  // namespace foveola::study
