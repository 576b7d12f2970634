#include "study/person/prompts/key_intent.h"

#include <map>

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

using namespace std::chrono_literals;

constexpr PersonKey all_keys[] = {PersonKey::mark, PersonKey::confirm, PersonKey::next,
                                  PersonKey::back, PersonKey::pause};
constexpr Phase all_phases[] = {
    Phase::created,   Phase::consent,         Phase::questionnaire, Phase::validation,
    Phase::reaction,  Phase::choosing_object, Phase::ready,         Phase::armed,
    Phase::marking,   Phase::rating,          Phase::paused,        Phase::interrupted,
    Phase::completed, Phase::withdrawn,       Phase::excluded,      Phase::refused};

using Meanings = std::map<PersonKey, KeyIntent>;

/// Every key that means something there.
Meanings meanings(Phase phase, bool reads_notice = false) {
  Meanings meanings;
  for (const PersonKey key : all_keys) {
    if (const auto intent = intent_of(key, phase, reads_notice)) {
      meanings.emplace(key, *intent);
    }
  }
  return meanings;
}

TEST(KeyIntent, EachPhaseHasItsKeys) {
  const std::map<Phase, Meanings> expected = {
      {Phase::validation,
       {{PersonKey::mark, KeyIntent::begin_validation},
        {PersonKey::confirm, KeyIntent::begin_validation}}},
      {Phase::reaction, {{PersonKey::mark, KeyIntent::press}}},
      {Phase::choosing_object,
       {{PersonKey::next, KeyIntent::next_object}, {PersonKey::confirm, KeyIntent::choose_object}}},
      {Phase::ready, {{PersonKey::mark, KeyIntent::start_trial}}},
      {Phase::marking,
       {{PersonKey::mark, KeyIntent::mark}, {PersonKey::back, KeyIntent::confirm_timing}}},
      {Phase::rating,
       {{PersonKey::confirm, KeyIntent::rate}, {PersonKey::back, KeyIntent::confirm_timing}}},
      {Phase::paused,
       {{PersonKey::mark, KeyIntent::resume},
        {PersonKey::confirm, KeyIntent::resume},
        {PersonKey::back, KeyIntent::confirm_stopping}}},
      {Phase::completed, {{PersonKey::confirm, KeyIntent::leave}}},
      {Phase::withdrawn, {{PersonKey::confirm, KeyIntent::leave}}},
      {Phase::excluded, {{PersonKey::confirm, KeyIntent::leave}}},
      {Phase::refused, {{PersonKey::confirm, KeyIntent::leave}}}};
  for (const Phase phase : all_phases) {
    const auto found = expected.find(phase);
    EXPECT_EQ(meanings(phase), found == expected.end() ? Meanings{} : found->second)
        << name_of(phase);
  }
}

TEST(KeyIntent, ANoticeIsReadBeforeAllElse) {
  const Meanings reads = {{PersonKey::mark, KeyIntent::read_on},
                          {PersonKey::confirm, KeyIntent::read_on}};
  for (const Phase phase : all_phases) {
    EXPECT_EQ(meanings(phase, true), reads) << name_of(phase);
  }
}

TEST(KeyIntent, SomeSayAWholeEvent) {
  const std::optional<Event> resumed = event_of(KeyIntent::resume);
  EXPECT_TRUE(resumed && std::holds_alternative<Resumed>(*resumed));
  EXPECT_FALSE(event_of(KeyIntent::read_on));
  EXPECT_FALSE(event_of(KeyIntent::mark)) << "it has the time of its key";
}

}  // namespace
}  // namespace foveola::study
