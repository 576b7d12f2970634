#include "study/person/forms/form.h"

#include "renderer/base/text/utf8.h"
#include "tests/matchers.h"
#include "tests/study/person/forms/typing.h"

namespace foveola::study {
namespace {

using test::press;
using test::type;

Form background() {
  return Form({.title = "About you",
               .questions = {test::age(), test::gender(), test::experience(), test::comments()},
               .confirmation = "Sure?",
               .confirm_keys = "[Enter] hand in"},
              {});
}

TEST(FormTest, GivesWhatWasAnswered) {
  Form form = background();
  type(form, U"42");
  press(form, {FormKey::enter, FormKey::down, FormKey::down, FormKey::tab, FormKey::right,
               FormKey::right, FormKey::enter});
  type(form, U"no");
  press(form, {FormKey::enter});
  EXPECT_FALSE(form.is_submitted());
  press(form, {FormKey::enter});
  EXPECT_TRUE(form.is_submitted());
  EXPECT_THAT(form.answers(), ElementsAre(Answer{"age", 42.0}, Answer{"gender", 1.0},
                                          Answer{"experience", 2.0}, Answer{"comments", "no"}));
}

TEST(FormTest, TimesEachQuestionForAsLongAsItIsShown) {
  using namespace std::chrono_literals;
  Form form = background();
  const auto press_at = [&](Nanoseconds time, std::initializer_list<FormKey> keys) {
    form.was_shown(time);
    press(form, keys);
  };
  form.was_shown(10s);
  form.was_shown(12s);  // its next frame
  type(form, U"42");
  press_at(13500ms, {FormKey::enter});  // 3.5 s, and gender is not yet on the display
  form.was_shown(14s);
  form.was_shown(15s);
  form.was_hidden();  // a pause
  form.was_shown(60s);
  press_at(61s, {FormKey::down, FormKey::tab});  // 1 s and 1 s
  form.was_shown(62s);
  press_at(62250ms, {FormKey::right, FormKey::up});  // 0.25 s, then back to gender
  form.was_shown(63s);
  press_at(63125ms, {FormKey::enter, FormKey::enter});  // 0.125 s more
  EXPECT_THAT(form.answers(),
              ElementsAre(Answer{"age", 42.0, 3500ms}, Answer{"gender", 5.0, 2125ms},
                          Answer{"experience", 1.0, 250ms}));
}

TEST(FormTest, ShowsAQuestionAtATimeAndWhereItIs) {
  Form form = background();
  type(form, U"4");
  ScreenPage screen = form.screen();
  EXPECT_EQ(screen.title, "About you (1 of 4)");
  ASSERT_THAT(screen.fields, SizeIs(1));
  EXPECT_EQ(screen.fields[0].question, "How old are you?");
  EXPECT_EQ(screen.fields[0].typed, "4");
  EXPECT_TRUE(screen.fields[0].has_focus);
  EXPECT_THAT(screen.keys, Not(HasSubstr("back")));
  type(form, U"0");
  press(form, {FormKey::enter});
  screen = form.screen();
  EXPECT_EQ(screen.title, "About you (2 of 4)");
  EXPECT_THAT(screen.keys, HasSubstr("[←] back"));
}

TEST(FormTest, ARequiredQuestionIsNotLeftWithoutAnAnswer) {
  for (const FormKey leave : {FormKey::enter, FormKey::tab}) {
    Form form = background();
    press(form, {leave, leave, leave});
    EXPECT_EQ(form.screen().title, "About you (1 of 4)");
    EXPECT_FALSE(form.screen().fields[0].fault.empty());
  }
}

TEST(FormTest, AnImpossibleAnswerIsSaidAtTheField) {
  Form form = background();
  type(form, U"17");
  press(form, {FormKey::enter});
  EXPECT_EQ(form.screen().title, "About you (1 of 4)");
  EXPECT_THAT(form.screen().fields[0].fault, HasSubstr("18"));
  press(form, {FormKey::erase});
  EXPECT_THAT(form.screen().fields[0].fault, IsEmpty());
  type(form, U"8");
  press(form, {FormKey::enter});
  EXPECT_EQ(form.screen().title, "About you (2 of 4)");
}

TEST(FormTest, AnAnswerTakenBackIsAskedForAgain) {
  Form form = background();
  type(form, U"42");
  press(form, {FormKey::enter, FormKey::down, FormKey::enter});
  press(form, {FormKey::up, FormKey::erase, FormKey::left});
  EXPECT_EQ(form.screen().title, "About you (1 of 4)");
  press(form, {FormKey::enter, FormKey::enter});
  EXPECT_EQ(form.screen().title, "About you (2 of 4)");
  EXPECT_FALSE(form.screen().fields[0].fault.empty());
}

TEST(FormTest, WhatMayBeLeftOutSaysSoAndIsNoAnswer) {
  Form form({.questions = {test::comments()}, .confirmation = "Sure?"}, {});
  EXPECT_EQ(form.screen().fields[0].question, "Anything else? (You may leave this out.)");
  press(form, {FormKey::enter});
  EXPECT_THAT(form.screen().paragraphs, ElementsAre("Sure?", "You left out 1 of the questions."));
  press(form, {FormKey::enter});
  EXPECT_TRUE(form.is_submitted());
  EXPECT_THAT(form.answers(), IsEmpty());
}

TEST(FormTest, NothingIsHandedInByOneSlip) {
  Form form({.questions = {test::experience()}, .confirmation = "It is {answers}"}, {});
  type(form, U"4");
  press(form, {FormKey::enter});
  EXPECT_THAT(form.screen().paragraphs, ElementsAre("It is 4"));
  EXPECT_THAT(form.screen().fields, IsEmpty());
  press(form, {FormKey::tab, FormKey::right});
  type(form, U"y 5");
  EXPECT_FALSE(form.is_submitted());
  press(form, {FormKey::up});
  type(form, U"5");
  press(form, {FormKey::enter, FormKey::enter});
  EXPECT_TRUE(form.is_submitted());
  EXPECT_THAT(form.answers(), ElementsAre(Answer{"experience", 5.0}));
}

TEST(FormTest, AFormThatWasHandedInStaysAsItIs) {
  Form form({.questions = {test::experience()}}, {});
  type(form, U"4");
  press(form, {FormKey::enter, FormKey::enter});
  EXPECT_FALSE(press(form, {FormKey::up}));
  EXPECT_FALSE(type(form, U"2"));
  EXPECT_THAT(form.answers(), ElementsAre(Answer{"experience", 4.0}));
}

TEST(FormTest, KeysThatMeanNothingAreLeftToOthers) {
  Form form = background();
  EXPECT_FALSE(press(form, {FormKey::up}));  // nothing to go back to
  EXPECT_FALSE(press(form, {FormKey::down}));
  EXPECT_FALSE(press(form, {FormKey::erase}));
  EXPECT_FALSE(type(form, U"q"));
}

TEST(FormTest, WithoutALastPageTheLastAnswerHandsItIn) {
  Form form({.intro = {"Read this."}, .questions = {test::gender()}}, {});
  press(form, {FormKey::enter, FormKey::enter});
  EXPECT_FALSE(form.is_submitted()) << "without an answer";
  EXPECT_FALSE(form.screen().fields[0].fault.empty());
  press(form, {FormKey::down, FormKey::enter});
  EXPECT_TRUE(form.is_submitted());
  EXPECT_THAT(form.answers(), ElementsAre(Answer{"gender", 5.0}));
  EXPECT_THAT(form.screen().fields, SizeIs(1)) << "no other page comes up";
}

// --- Pages of words ---

std::size_t lines_on(const std::vector<std::string>& page) {
  std::size_t lines = page.size() - 1;
  for (const std::string& paragraph : page) {
    const std::size_t characters = count_characters(paragraph);
    lines += (characters + screen_line_characters - 1) / screen_line_characters;
  }
  return lines;
}

TEST(PagesOfWords, ShortOnesAreOnePage) {
  EXPECT_THAT(split_into_pages({"one", "two"}), ElementsAre(ElementsAre("one", "two")));
  EXPECT_THAT(split_into_pages({}), IsEmpty());
}

TEST(PagesOfWords, LongOnesAreBrokenAndLoseNothing) {
  std::string paragraph;
  for (int i = 0; i < 400; ++i) {
    paragraph += (i > 0 ? " " : "") + std::string("слово") + std::to_string(i);
  }
  const auto pages = split_into_pages({"first", paragraph, "last"});
  EXPECT_GT(pages.size(), 3U);
  std::string all;
  for (const auto& page : pages) {
    EXPECT_LE(lines_on(page), max_screen_lines);
    for (const std::string& part : page) {
      all += (all.empty() ? "" : " ") + part;
    }
  }
  EXPECT_EQ(all, "first " + paragraph + " last");
}

TEST(PagesOfWords, AWordWithoutEndIsBrokenToo) {
  const std::string endless(2000, 'x');
  std::string all;
  for (const auto& page : split_into_pages({endless})) {
    EXPECT_LE(lines_on(page), max_screen_lines);
    all += page.front();
  }
  EXPECT_EQ(all, endless);
}

TEST(PagesOfWords, AreTurnedAndTurnedBack) {
  const std::string page(screen_line_characters * max_screen_lines * 3 / 4, 'x');
  Form form({.title = "Read", .intro = {page + "1", page + "2"}}, {});
  EXPECT_THAT(form.screen().paragraphs, ElementsAre(page + "1"));
  press(form, {FormKey::enter});
  EXPECT_THAT(form.screen().paragraphs, ElementsAre(page + "2"));
  EXPECT_THAT(form.screen().keys, HasSubstr("back"));
  press(form, {FormKey::up});
  EXPECT_THAT(form.screen().paragraphs, ElementsAre(page + "1"));
}

}  // namespace
}  // namespace foveola::study
