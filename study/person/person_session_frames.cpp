// What the participant sees, frame by frame.
#include <fmt/format.h>

#include "study/person/console_words.h"
#include "study/person/person_session.h"
#include "study/stage/trial_preview.h"

namespace foveola::study {
namespace {

/// By then a page's words have been measured and stand.
constexpr int frame_to_keep = 3;

}  // namespace

void PersonSession::show_frame() {
  keep_picture_of_new_page();
  reaction_appears_ = reaction_ && reaction_->appears_at(parts_.clock->now());
  Nanoseconds shown{0};
  if (attempt_) {
    shown = attempt_->next();
  } else {
    shown = parts_.display->show(picture());
    arrived_.clear();
    parts_.eye->poll(parts_.clock->now(), arrived_);
  }
  page_shown_ = page_shown_.value_or(shown);
  tell_of_tracker();
  go_on(shown);
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
      if (attempt_) {
        feed(FirstFramePresented{in_session(shown)});
      }
      break;
    case Phase::marking:
      go_on_timing();
      break;
    case Phase::rating:
      go_on_looking_around();
      break;
    default:
      break;
  }
}

void PersonSession::go_on_validating() {
  if (!validation_) {
    return;
  }
  validation_->update(parts_.clock->now(), arrived_);
  if (validation_->result()) {
    feed(*validation_->result());
    validation_.reset();
  }
}

void PersonSession::go_on_reacting(Nanoseconds shown) {
  if (!notices_.empty()) {
    return;
  }
  if (!reaction_) {
    reaction_.emplace(*parts_.protocol->reaction, shown, waits_);
    return;
  }
  if (reaction_appears_) {
    reaction_->was_shown(shown);
  }
  if (const std::optional<ReactionPressed> pressed = reaction_->result()) {
    feed(ReactionPressed{.shown = in_session(pressed->shown), .time = in_session(pressed->time)});
    reaction_.reset();
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

void PersonSession::go_on_looking_around() {
  if (!form_ && wants_to_rate_ && now() >= look_around_until_) {
    form_.emplace(rating_form(parts_.protocol->ratings, texts()));
    form_of_.clear();
    show_new_page();
  }
}

SessionPicture PersonSession::picture() {
  const Quat head = head_orientation(viewer_->head.pose(parts_.clock->now()).heading);
  return {.head = head, .overlays = overlays(head), .screen = page()};
}

ViewOverlays PersonSession::overlays(const Quat& head) const {
  ViewOverlays overlays;
  if (seen_.phase == Phase::validation && validation_) {
    overlays.target = head * validation_->target().value_or(Vec3(0.0F, 0.0F, -1.0F));
  } else if (seen_.phase == Phase::choosing_object) {
    overlays.offers = rings_of(stage().objects(), object_ahead_now());
  } else if (seen_.phase == Phase::ready) {
    overlays.offers = {ring_of(stage().objects(), seen_.object)};
  }
  return overlays;
}

std::optional<ScreenPage> PersonSession::page() const {
  std::optional<ScreenPage> page = page_of_phase();
  if (page && page->covers_picture && !page->is_signal) {
    page->progress =
        static_cast<double>(seen_.step) / static_cast<double>(log_.procedure().agenda.size());
  }
  return page;
}

std::optional<ScreenPage> PersonSession::page_of_phase() const {
  if (doubt_) {
    return *doubt_ == Doubt::timing_again ? retiming_screen(texts())
                                          : notice_screen(Notice::stopping, texts());
  }
  if (!notices_.empty()) {
    return notices_.front();
  }
  const std::vector<MarkEntry>& marks = parts_.protocol->marks;
  const bool acknowledges = now() < acknowledged_until_;
  switch (seen_.phase) {
    case Phase::created:
    case Phase::interrupted:
      return notice_screen(Notice::loading, texts());
    case Phase::consent:
    case Phase::questionnaire:
      return form_->screen();
    case Phase::validation:
      return validation_ ? std::nullopt : std::optional(page_of_validation());
    case Phase::reaction:
      return page_of_reaction();
    case Phase::choosing_object:
      return choosing_screen(texts());
    case Phase::ready:
      return ready_screen(marks, trial_count(), seen_.timing > 1, texts());
    case Phase::armed:
      return std::nullopt;
    case Phase::marking:
      return acknowledges ? std::optional(mark_taken_screen(seen_.mark, marks.size(), texts()))
                          : std::nullopt;
    case Phase::rating:
      if (form_) {
        return form_->screen();
      }
      return acknowledges ? mark_taken_screen(marks.size(), marks.size(), texts())
                          : look_around_screen(texts());
    default:
      return page_of_end();
  }
}

ScreenPage PersonSession::page_of_validation() const {
  const bool is_first = seen_.validations_left == parts_.protocol->tracker.validation->attempts;
  return notice_screen(is_first ? Notice::validation : Notice::validation_again, texts());
}

ScreenPage PersonSession::page_of_reaction() const {
  if (reaction_appears_) {
    return reaction_now_screen(texts());
  }
  return was_false_start_ ? reaction_early_screen(texts()) : reaction_wait_screen(texts());
}

ScreenPage PersonSession::page_of_end() const {
  switch (seen_.phase) {
    case Phase::paused:
      return notice_screen(Notice::pause, texts());
    case Phase::completed:
      return notice_screen(Notice::goodbye, texts());
    case Phase::withdrawn:
      return notice_screen(Notice::withdrawn, texts());
    case Phase::refused:
      return notice_screen(Notice::refused, texts());
    default:
      return notice_screen(Notice::interrupted, texts());
  }
}

TrialCount PersonSession::trial_count() const {
  // Who takes part must not know of catch trials: they count as others do.
  const auto is_practice = [](const PlannedTrial& one) { return one.kind == TrialKind::practice; };
  TrialCount count{.trial = 0, .trials = 0};
  const std::size_t index = *trial_of(log_.procedure(), seen_);
  for (std::size_t i = 0; i < parts_.plan->size(); ++i) {
    const bool counts = is_practice((*parts_.plan)[i]) == is_practice((*parts_.plan)[index]);
    count.trials += counts ? 1 : 0;
    count.trial += counts && i <= index ? 1 : 0;
  }
  return count;
}

void PersonSession::show_new_page() {
  page_shown_.reset();
  // Here, for within an attempt a page may come and be shown between two looks at it.
  frames_of_page_ = 0;
}

void PersonSession::keep_picture_of_new_page() {
  const bool stands = page_shown_ && !log_.has_effects_to_come();
  frames_of_page_ = stands ? frames_of_page_ + 1 : 0;
  if (settings_.screens && frames_of_page_ == frame_to_keep) {
    ++screens_taken_;
    parts_.display->take_picture(*settings_.screens /
                                 fmt::format("{:03}-{}.png", screens_taken_, name_of(seen_.phase)));
  }
}

}  // namespace foveola::study
