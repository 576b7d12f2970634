// Checks of whether the participant looks at the trial's object, and their consequences.
#include <utility>

#include <fmt/format.h>

#include "study/person/person_session.h"
#include "study/stage/offered_object.h"
#include "study/stage/trial_preview.h"

namespace foveola::study {
namespace {

/// A larger share than this counts as most of a trial.
constexpr double most = 0.5;

}  // namespace

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

}  // namespace foveola::study
