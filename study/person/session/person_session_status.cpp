// Status lines of a person's session for the experimenter.
#include <utility>

#include <fmt/format.h>

#include "study/console/console_words.h"
#include "study/person/prompts/pages.h"
#include "study/person/session/person_session.h"

namespace foveola::study {

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
