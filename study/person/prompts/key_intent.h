// What a participant's key means where the session is.
#pragma once

#include <optional>

#include "study/person/prompts/person_keys.h"
#include "study/session/session.h"

namespace foveola::study {

enum class KeyIntent {
  read_on,  ///< the notice was read
  // They ask for a confirmation.
  confirm_timing,
  confirm_stopping,
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

/// Empty if it means nothing there. A notice comes before the phase; confirmations and forms take
/// their keys themselves. PersonKey::pause is left to others.
std::optional<KeyIntent> intent_of(PersonKey key, Phase phase, bool reads_notice);

/// The event of the session that the intent is, if it says all of one.
std::optional<Event> event_of(KeyIntent intent);

}  // namespace foveola::study
