#include "study/person/forms/confirmation.h"

#include "tests/matchers.h"
#include "tests/study/person/forms/typing.h"

namespace foveola::study {
namespace {

using test::press;
using test::type;

bool withdraws(const Confirmation& confirmation) {
  return confirmation.chosen() && std::holds_alternative<Withdrawn>(*confirmation.chosen());
}

TEST(ConfirmationTest, BeginsOnContinue) {
  for (const Confirmed what : {Confirmed::stopping, Confirmed::timing_again}) {
    const Confirmation confirmation(what, {});
    EXPECT_FALSE(confirmation.chosen());
    const ScreenPage screen = confirmation.screen({});
    ASSERT_EQ(screen.fields.size(), 1U);
    EXPECT_EQ(screen.fields[0].chosen, 0U);
    EXPECT_THAT(screen.fields[0].labels[0], HasSubstr("ontinue"));
    EXPECT_THAT(screen.keys, HasSubstr("[↓]"));
  }
}

TEST(ConfirmationTest, ArrowsDigitsAndASingleButtonChoose) {
  Confirmation confirmation(Confirmed::stopping, {});
  press(confirmation, {FormKey::down});
  EXPECT_TRUE(withdraws(confirmation));
  press(confirmation, {FormKey::down});
  EXPECT_TRUE(withdraws(confirmation));
  press(confirmation, {FormKey::up});
  EXPECT_FALSE(confirmation.chosen());
  type(confirmation, U"2");
  EXPECT_TRUE(withdraws(confirmation));
  type(confirmation, U"1");
  press(confirmation, {FormKey::step});
  EXPECT_TRUE(withdraws(confirmation));
  press(confirmation, {FormKey::step});
  EXPECT_FALSE(confirmation.chosen());

  Confirmation timing(Confirmed::timing_again, {});
  press(timing, {FormKey::down});
  EXPECT_TRUE(std::holds_alternative<RetimeRequested>(timing.chosen().value()));
}

// What withdrew once was "y", in a text answer after Escape and Backspace.
TEST(ConfirmationTest, WhatIsTypedInATextAnswerChoosesNothing) {
  Confirmation confirmation(Confirmed::stopping, {});
  for (const std::u32string text :
       {U"yes, the view was nice", U"y", U"j", U"да", U"stop", U"3 0"}) {
    EXPECT_FALSE(type(confirmation, text));
  }
  EXPECT_FALSE(press(confirmation, {FormKey::erase, FormKey::tab, FormKey::left, FormKey::right}));
  EXPECT_FALSE(confirmation.chosen());
}

}  // namespace
}  // namespace foveola::study
