// What a participant's key means where the session is.
#pragma once

#include <optional>

#include "study/person/person_keys.h"
#include "study/session/session.h"

namespace foveola::study {

/// What the participant is asked to confirm.
enum class Confirmation { timing_again, stopping };

enum class KeyIntent {
  read_on,  ///< the notice was read
  // They answer a confirmation.
  time_again,
  stop_taking_part,
  let_confirmation_go,
  // They ask for a confirmation.
  confirm_timing,
  confirm_going_on,
  // They answer what the phase waits for.
  begin_validation,
  press,  ///< the key at what appears
  next_object,
  choose_object,
  start_trial,
  mark,
  rate,
  resume,
  leave,
};

/// Empty if it means nothing there. A confirmation comes before a notice, a notice before the
/// phase. Forms take what they need before; PersonKey::pause is left to others.
std::optional<KeyIntent> intent_of(PersonKey key, Phase phase,
                                   const std::optional<Confirmation>& confirmation,
                                   bool reads_notice);

/// The event of the session that the intent is, if it says all of one.
std::optional<Event> event_of(KeyIntent intent);

}  // namespace foveola::study
