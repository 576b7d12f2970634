#include "study/person/forms/question_entry.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "tests/matchers.h"
#include "tests/study/person/forms/typing.h"

namespace foveola::study {
namespace {

using test::press;
using test::type;

TEST(QuestionEntryTest, AScaleIsAnsweredByArrowsAndDigits) {
  QuestionEntry entry(test::experience());
  EXPECT_TRUE(entry.is_empty());
  EXPECT_THAT(entry.value(), VariantWith<std::string>(""));
  EXPECT_TRUE(press(entry, {FormKey::right}));
  EXPECT_THAT(entry.value(), VariantWith<double>(1.0));
  EXPECT_TRUE(press(entry, {FormKey::right, FormKey::right, FormKey::left}));
  EXPECT_THAT(entry.value(), VariantWith<double>(2.0));
  EXPECT_TRUE(type(entry, U"5"));
  EXPECT_THAT(entry.value(), VariantWith<double>(5.0));
  EXPECT_TRUE(press(entry, {FormKey::right}));  // there is no sixth
  EXPECT_THAT(entry.value(), VariantWith<double>(5.0));
  EXPECT_EQ(entry.shown_value(), "5");
}

TEST(QuestionEntryTest, AScaleTakesOnlyItsOwnPoints) {
  QuestionEntry entry(test::experience());
  EXPECT_FALSE(type(entry, U"6"));
  EXPECT_FALSE(type(entry, U"0"));
  EXPECT_FALSE(type(entry, U"x"));
  EXPECT_FALSE(press(entry, {FormKey::up}));
  EXPECT_FALSE(press(entry, {FormKey::erase}));
  EXPECT_TRUE(entry.is_empty());
  QuestionEntry from_zero(Question{.id = "symptom", .minimum = 0.0, .maximum = 3.0});
  EXPECT_TRUE(type(from_zero, U"0"));
  EXPECT_THAT(from_zero.value(), VariantWith<double>(0.0));
}

TEST(QuestionEntryTest, LeftBeginsAtAScalesEnd) {
  QuestionEntry entry(test::experience());
  press(entry, {FormKey::left});
  EXPECT_THAT(entry.value(), VariantWith<double>(5.0));
}

TEST(QuestionEntryTest, AScaleShowsItsNumbersAndWords) {
  EXPECT_THAT(QuestionEntry(test::experience()).field().labels,
              ElementsAre("1\nnot at all", "2", "3", "4", "5\nvery"));
  EXPECT_THAT(QuestionEntry(Question{.minimum = -1.0, .maximum = 1.0, .labels = {"a", "b", "c"}})
                  .field()
                  .labels,
              ElementsAre("-1\na", "0\nb", "1\nc"));
}

TEST(QuestionEntryTest, ASingleButtonGoesRound) {
  QuestionEntry scale(test::experience());
  press(scale, {FormKey::step, FormKey::step});
  EXPECT_THAT(scale.value(), VariantWith<double>(2.0));
  press(scale, {FormKey::step, FormKey::step, FormKey::step, FormKey::step});
  EXPECT_THAT(scale.value(), VariantWith<double>(1.0));
  QuestionEntry list(test::gender());
  press(list, {FormKey::step, FormKey::step, FormKey::step, FormKey::step});
  EXPECT_EQ(list.shown_value(), "female");
  QuestionEntry words(Question{.id = "words", .kind = QuestionKind::text});
  EXPECT_FALSE(press(words, {FormKey::step}));
}

TEST(QuestionEntryTest, ANumberIsCountedByArrowsAsWell) {
  QuestionEntry age(
      Question{.id = "age", .kind = QuestionKind::number, .minimum = 18.0, .maximum = 20.0});
  press(age, {FormKey::right});
  EXPECT_THAT(age.value(), VariantWith<double>(18.0));
  press(age, {FormKey::right, FormKey::right, FormKey::right});
  EXPECT_THAT(age.value(), VariantWith<double>(20.0));
  press(age, {FormKey::left});
  EXPECT_EQ(age.shown_value(), "19");
  press(age, {FormKey::step, FormKey::step});
  EXPECT_THAT(age.value(), VariantWith<double>(18.0)) << "after the last one the first";
  type(age, U"20");
  EXPECT_THAT(age.value(), VariantWith<double>(20.0)) << "what is typed begins anew";
  QuestionEntry from_above(
      Question{.id = "age", .kind = QuestionKind::number, .minimum = 18.0, .maximum = 20.0});
  press(from_above, {FormKey::left});
  EXPECT_THAT(from_above.value(), VariantWith<double>(20.0));
}

TEST(QuestionEntryTest, AScaleOfManyPointsIsTyped) {
  Question question = test::experience();
  question.maximum = 100.0;
  QuestionEntry entry(question);
  EXPECT_EQ(entry.field().kind, ScreenField::Kind::line);
  EXPECT_TRUE(type(entry, U"73"));
  EXPECT_THAT(entry.value(), VariantWith<double>(73.0));
}

TEST(QuestionEntryTest, AChoiceIsMadeByArrowsAndDigits) {
  QuestionEntry entry(test::gender());
  EXPECT_THAT(entry.field().labels, ElementsAre("1  female", "2  male", "3  other"));
  EXPECT_TRUE(press(entry, {FormKey::down}));
  EXPECT_THAT(entry.value(), VariantWith<double>(5.0));
  EXPECT_EQ(entry.shown_value(), "female");
  EXPECT_TRUE(press(entry, {FormKey::down, FormKey::down}));
  EXPECT_THAT(entry.value(), VariantWith<std::string>("other"));
  EXPECT_TRUE(press(entry, {FormKey::up}));
  EXPECT_THAT(entry.value(), VariantWith<double>(1.0));
  EXPECT_TRUE(type(entry, U"3"));
  EXPECT_THAT(entry.field().chosen, Optional(2U));
  EXPECT_FALSE(type(entry, U"4"));
  EXPECT_FALSE(type(entry, U"0"));
  EXPECT_TRUE(press(entry, {FormKey::erase}));
  EXPECT_TRUE(entry.is_empty());
}

TEST(QuestionEntryTest, ANumberIsTyped) {
  QuestionEntry entry(test::age());
  EXPECT_FALSE(type(entry, U"x"));
  EXPECT_TRUE(type(entry, U"421"));
  EXPECT_TRUE(press(entry, {FormKey::erase}));
  EXPECT_THAT(entry.value(), VariantWith<double>(42.0));
  EXPECT_TRUE(type(entry, U",5"));
  EXPECT_THAT(entry.value(), VariantWith<double>(42.5));
  EXPECT_TRUE(type(entry, U"-"));
  EXPECT_THAT(entry.value(), VariantWith<std::string>("42,5-"));
}

Question income() {
  return {.id = "income", .kind = QuestionKind::number, .minimum = 0.0, .maximum = 1e6};
}

TEST(QuestionEntryTest, ANumberIsShownAsItIsRead) {
  QuestionEntry entry(income());
  type(entry, U"1.500");
  EXPECT_EQ(entry.field().note, "") << "it may be either";
  type(entry, U",50");
  EXPECT_EQ(entry.field().note, "= 1500.5");
  EXPECT_EQ(entry.shown_value(), "1500.5");
  EXPECT_THAT(entry.value(), VariantWith<double>(1500.5));
  QuestionEntry plain(income());
  type(plain, U"1500");
  EXPECT_EQ(plain.field().note, "");
}

TEST(QuestionEntryTest, ANumberThatMayBeEitherIsAskedFor) {
  for (const std::u32string typed : {U"1,500", U"1.500"}) {
    QuestionEntry entry(income());
    type(entry, typed);
    EXPECT_FALSE(std::holds_alternative<double>(entry.value()));
    const std::string mark(1, static_cast<char>(typed[1]));
    EXPECT_EQ(entry.fault({}),
              "Please type 1" + mark + "5 or 1500: 1" + mark + "500 may be either.");
    press(entry, {FormKey::erase, FormKey::erase});
    EXPECT_EQ(entry.fault({}), "");
    EXPECT_THAT(entry.value(), VariantWith<double>(1.5));
  }
}

TEST(QuestionEntryTest, NumbersDoNotGoOnForever) {
  QuestionEntry entry(test::age());
  EXPECT_FALSE(type(entry, std::u32string(40, U'1')));
  EXPECT_EQ(entry.field().typed, std::string(12, '1'));
}

TEST(QuestionEntryTest, WordsAreTypedInAnyScript) {
  QuestionEntry entry(test::comments());
  EXPECT_TRUE(type(entry, U"Schön, да, ναι 1"));
  EXPECT_THAT(entry.value(), VariantWith<std::string>("Schön, да, ναι 1"));
  EXPECT_TRUE(press(entry, {FormKey::erase, FormKey::erase, FormKey::erase}));
  EXPECT_THAT(entry.value(), VariantWith<std::string>("Schön, да, να"));
  EXPECT_FALSE(type(entry, U"\x07"));
  EXPECT_FALSE(press(entry, {FormKey::left}));
}

WindowEvent key_down(int key) { return {.what = KeyMoved{.key = key, .is_down = true}}; }

TEST(FormInputTest, ReadsTheKeyboard) {
  EXPECT_THAT(form_input(key_down(GLFW_KEY_ENTER)), Optional(FormInput(FormKey::enter)));
  EXPECT_THAT(form_input(key_down(GLFW_KEY_KP_ENTER)), Optional(FormInput(FormKey::enter)));
  EXPECT_THAT(form_input(key_down(GLFW_KEY_TAB)), Optional(FormInput(FormKey::tab)));
  EXPECT_THAT(form_input(key_down(GLFW_KEY_LEFT)), Optional(FormInput(FormKey::left)));
  EXPECT_THAT(form_input(key_down(GLFW_KEY_RIGHT)), Optional(FormInput(FormKey::right)));
  EXPECT_THAT(form_input(key_down(GLFW_KEY_UP)), Optional(FormInput(FormKey::up)));
  EXPECT_THAT(form_input(key_down(GLFW_KEY_DOWN)), Optional(FormInput(FormKey::down)));
  EXPECT_THAT(form_input(key_down(GLFW_KEY_BACKSPACE)), Optional(FormInput(FormKey::erase)));
  EXPECT_THAT(form_input({.what = CharacterTyped{U'ß'}}), Optional(FormInput(U'ß')));
}

TEST(FormInputTest, LeavesTheRestAlone) {
  EXPECT_EQ(form_input(key_down(GLFW_KEY_ESCAPE)), std::nullopt);
  EXPECT_EQ(form_input(key_down(GLFW_KEY_A)), std::nullopt);  // it is typed as well
  EXPECT_EQ(form_input({.what = KeyMoved{.key = GLFW_KEY_ENTER, .is_down = false}}), std::nullopt);
  EXPECT_EQ(form_input({.what = CloseWanted{}}), std::nullopt);
}

}  // namespace
}  // namespace foveola::study
