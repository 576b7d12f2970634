// Maps participants' key presses to session intents.
#pragma once

#include <optional>

#include "study/person/prompts/person_keys.h"
#include "study/session/session.h"

namespace foveola::study {

enum class KeyIntent {
  read_on,  ///< the notice has been read
  // Intents that open a confirmation.
  confirm_timing,
  confirm_stopping,
  // Intents that answer the phase's effect.
  begin_validation,
  press,  ///< a press in the reaction test
  next_object,
  choose_object,
  start_trial,
  mark,
  rate,
  resume,
  leave,
};

/// Returns the key's intent in this phase; empty if it has no meaning there. A notice takes keys
/// before the phase; confirmations and forms handle their keys themselves. PersonKey::pause is the
/// caller's.
std::optional<KeyIntent> intent_of(PersonKey key, Phase phase, bool reads_notice);

/// Returns the session event of an intent; empty if the intent alone does not determine it.
std::optional<Event> event_of(KeyIntent intent);

}  // namespace foveola::study
