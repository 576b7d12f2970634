#include "study/driver/reaction_test.h"

namespace foveola::study {
namespace {

Nanoseconds drawn_wait(const ReactionSettings& settings, Pcg32& random) {
  const double span_s = settings.longest_wait_s - settings.shortest_wait_s;
  return nanoseconds_from_seconds(settings.shortest_wait_s + span_s * random.uniform());
}

}  // namespace

ReactionTest::ReactionTest(const ReactionSettings& settings, Nanoseconds start, Pcg32& random)
    : due_(start + drawn_wait(settings, random)) {}

void ReactionTest::was_shown(Nanoseconds time) { shown_ = shown_.value_or(time); }

void ReactionTest::was_pressed(Nanoseconds time) { pressed_ = pressed_.value_or(time); }

std::optional<ReactionPressed> ReactionTest::result() const {
  if (!pressed_) {
    return std::nullopt;
  }
  if (shown_) {
    return ReactionPressed{.shown = *shown_, .time = *pressed_};
  }
  if (*pressed_ < due_) {
    return ReactionPressed{.shown = due_, .time = *pressed_};
  }
  return std::nullopt;  // it is on its way to the display
}

}  // namespace foveola::study
