// What the participant sees, frame by frame.
#include <algorithm>

#include <fmt/format.h>

#include "study/person/object_pick.h"
#include "study/person/pages.h"
#include "study/person/person_session.h"
#include "study/stage/trial_preview.h"

namespace foveola::study {
namespace {

constexpr Vec3 forward{0.0F, 0.0F, -1.0F};

/// The part of a picture of the whole window.
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

void PersonSession::show_frame() {
  const std::optional<int> number = page_watch_.picture_due(!log_.has_effects_to_come());
  if (number && settings_.screens) {
    parts_.display->take_picture(*settings_.screens /
                                 fmt::format("{:03}-{}.png", *number, name_of(seen_.phase)));
  }
  prompt_.reaction.begin_frame(parts_.clock->now());
  if (parts_.simulated_operator != nullptr && attempt_ &&
      parts_.simulated_operator->wants_to_look()) {
    parts_.display->keep_pixels();
  }
  Nanoseconds shown{0};
  if (attempt_) {
    shown = attempt_->next();
  } else {
    shown = parts_.display->show(picture());
    arrived_.clear();
    parts_.eye->poll(parts_.clock->now(), arrived_);
  }
  page_watch_.was_shown(shown);
  tell_of_tracker();
  tell_of_slow_drawing();
  if (parts_.simulated_operator != nullptr) {
    show_to_operator(shown);
  }
  go_on(shown);
}

void PersonSession::show_to_operator(Nanoseconds shown) {
  const bool is_in_trial = trial_of(log_.procedure(), seen_).has_value();
  parts_.simulated_operator->follow({.prompt = prompt_,
                                     .context = context(),
                                     .offered = is_in_trial ? &stage().objects() : nullptr,
                                     .shown = shown,
                                     .session_time = now(),
                                     .pixels = take_pixels()},
                                    !log_.has_effects_to_come());
}

std::optional<ShownPixels> PersonSession::take_pixels() {
  std::optional<RgbImage> pixels = parts_.display->take_pixels();
  if (!pixels || !attempt_) {
    return std::nullopt;
  }
  return ShownPixels{.image = cut(std::move(*pixels), parts_.display->geometry().parts.front()),
                     .viewport = attempt_->viewport()};
}

void PersonSession::go_on(Nanoseconds shown) {
  if (log_.has_effects_to_come()) {
    return;
  }
  switch (log_.state().phase) {
    case Phase::validation:
      go_on_validating();
      break;
    case Phase::reaction:
      go_on_reacting(shown);
      break;
    case Phase::armed:
      go_on_arming(shown);
      break;
    case Phase::marking:
      go_on_timing();
      break;
    case Phase::rating:
      if (begin_rating(prompt_, *parts_.protocol, now())) {
        page_watch_.turn_page();
      }
      break;
    default:
      break;
  }
}

void PersonSession::go_on_validating() {
  if (!prompt_.validation) {
    return;
  }
  prompt_.validation->update(parts_.clock->now(), arrived_);
  if (prompt_.validation->result()) {
    feed(*prompt_.validation->result());
    prompt_.validation.reset();
  }
}

void PersonSession::go_on_reacting(Nanoseconds shown) {
  if (!prompt_.notices.empty()) {
    return;
  }
  if (const auto pressed = prompt_.reaction.end_frame(*parts_.protocol->reaction, shown)) {
    feed(ReactionPressed{.shown = pressed->shown - zero_, .time = pressed->time - zero_});
  }
}

void PersonSession::go_on_arming(Nanoseconds shown) {
  if (attempt_) {
    feed(FirstFramePresented{shown - zero_});
  } else if (prompt_.awaits_gaze && parts_.eye->has_gaze(parts_.clock->now())) {
    prompt_.awaits_gaze = false;
    page_watch_.turn_page();
    prepare_rendering();
  }
}

void PersonSession::go_on_timing() {
  answer_window();  // a press may have come in time while the frame was rendered
  const bool still_waits = log_.state().phase == Phase::marking && !log_.has_effects_to_come();
  const Nanoseconds deadline = log_.state().first_frame +
                               nanoseconds_from_seconds(mark_timeout_s(*parts_.protocol, trial()));
  if (still_waits && now() >= deadline) {
    feed(TimedOut{deadline});
  }
}

SessionPicture PersonSession::picture() {
  SessionPicture picture{.head = viewer_.orientation(parts_.clock->now()),
                         .screen = page_of(prompt_, context(), now())};
  if (seen_.phase == Phase::validation && prompt_.validation) {
    picture.overlays.target = picture.head * prompt_.validation->target().value_or(forward);
  } else if (seen_.phase == Phase::choosing_object) {
    picture.overlays.offers = rings_of(stage().objects(), object_ahead_now());
  } else if (seen_.phase == Phase::ready) {
    picture.overlays.offers = {ring_of(stage().objects(), seen_.object)};
  }
  return picture;
}

std::size_t PersonSession::object_ahead_now() {
  const Quat head = viewer_.orientation(parts_.clock->now());
  return object_ahead(stage().objects(), head * forward);
}

}  // namespace foveola::study
