#include "study/person/prompts/key_intent.h"

namespace foveola::study {
namespace {

using MaybeIntent = std::optional<KeyIntent>;

bool goes_on(PersonKey key) { return key == PersonKey::mark || key == PersonKey::confirm; }

MaybeIntent intent_if(bool is_meant, KeyIntent intent) {
  return is_meant ? MaybeIntent(intent) : std::nullopt;
}

/// Of a phase with two keys: one continues, the other opens a confirmation.
MaybeIntent intent_of_two(PersonKey key, PersonKey first, KeyIntent intent, PersonKey second,
                          KeyIntent other) {
  return key == first ? MaybeIntent(intent) : intent_if(key == second, other);
}

MaybeIntent intent_in_phase(PersonKey key, Phase phase) {
  switch (phase) {
    case Phase::validation:
      return intent_if(goes_on(key), KeyIntent::begin_validation);
    case Phase::reaction:
      return intent_if(key == PersonKey::mark, KeyIntent::press);
    case Phase::choosing_object:
      return intent_of_two(key, PersonKey::next, KeyIntent::next_object, PersonKey::confirm,
                           KeyIntent::choose_object);
    case Phase::ready:
      return intent_if(key == PersonKey::mark, KeyIntent::start_trial);
    case Phase::marking:
      return intent_of_two(key, PersonKey::mark, KeyIntent::mark, PersonKey::back,
                           KeyIntent::confirm_timing);
    case Phase::rating:
      return intent_of_two(key, PersonKey::confirm, KeyIntent::rate, PersonKey::back,
                           KeyIntent::confirm_timing);
    case Phase::paused:
      return goes_on(key) ? MaybeIntent(KeyIntent::resume)
                          : intent_if(key == PersonKey::back, KeyIntent::confirm_stopping);
    case Phase::completed:
    case Phase::withdrawn:
    case Phase::excluded:
    case Phase::refused:
      return intent_if(key == PersonKey::confirm, KeyIntent::leave);
    case Phase::created:
    case Phase::consent:
    case Phase::questionnaire:
    case Phase::armed:
    case Phase::interrupted:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<KeyIntent> intent_of(PersonKey key, Phase phase, bool reads_notice) {
  return reads_notice ? intent_if(goes_on(key), KeyIntent::read_on) : intent_in_phase(key, phase);
}

std::optional<Event> event_of(KeyIntent intent) {
  switch (intent) {
    case KeyIntent::start_trial:
      return TrialStarted{};
    case KeyIntent::resume:
      return Resumed{};
    default:
      return std::nullopt;
  }
}

}  // namespace foveola::study
