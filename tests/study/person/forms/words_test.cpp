#include "study/person/forms/words.h"

#include "study/person/forms/confirmation.h"
#include "study/protocol/built_in_texts.h"
#include "tests/matchers.h"
#include "tests/study/person/forms/typing.h"

namespace foveola::study {
namespace {

using test::press;
using test::type;

constexpr Notice notices[] = {Notice::welcome,          Notice::loading,     Notice::validation,
                              Notice::validation_again, Notice::refused,     Notice::practice,
                              Notice::first_trial,      Notice::next_scene,  Notice::pause,
                              Notice::withdrawn,        Notice::interrupted, Notice::goodbye};

const std::vector<MarkEntry> two_marks = {
    {.id = "outline", .instruction = "You see its outline."},
    {.id = "material", .instruction = "You see its material."}};

/// Every page and band that is made without a form.
std::vector<ScreenPage> plain_screens(const Texts& texts) {
  std::vector<ScreenPage> screens = {reaction_screen(10, texts),
                                     reaction_wait_screen(texts),
                                     reaction_now_screen(texts),
                                     reaction_early_screen(texts),
                                     choosing_screen({.name = "Lamp"}, texts),
                                     no_gaze_screen(texts),
                                     mark_taken_screen(1, 2, texts),
                                     look_around_screen(texts),
                                     Confirmation(Confirmed::timing_again, texts).screen(texts),
                                     Confirmation(Confirmed::stopping, texts).screen(texts)};
  screens.push_back(ready_screen(two_marks, {.object = {.name = "Lamp"}}, texts));
  for (const TimedAgain again : {TimedAgain::no, TimedAgain::asked_for,
                                 TimedAgain::object_out_of_view, TimedAgain::gaze_elsewhere}) {
    screens.push_back(ready_screen(
        two_marks,
        {.object = {.name = "Lamp", .is_in_view = false}, .count = {3, 15}, .again = again},
        texts));
  }
  for (const Notice notice : notices) {
    screens.push_back(notice_screen(notice, texts));
  }
  return screens;
}

std::vector<std::string> words_on(const ScreenPage& screen) {
  std::vector<std::string> words = screen.paragraphs;
  words.push_back(screen.title);
  words.push_back(screen.keys);
  for (const ScreenField& field : screen.fields) {
    words.push_back(field.question);
  }
  return words;
}

TEST(WordsTest, EveryScreenHasATitleAndNoGaps) {
  for (const ScreenPage& screen : plain_screens({})) {
    EXPECT_FALSE(screen.title.empty());
    EXPECT_THAT(words_on(screen), Each(Not(AnyOf(HasSubstr("{"), HasSubstr("}"))))) << screen.title;
  }
}

TEST(WordsTest, NoMethodIsNamed) {
  for (const BuiltInText& text : built_in_texts()) {
    EXPECT_THAT(std::string(text.english),
                Not(AnyOf(HasSubstr("foveat"), HasSubstr("OD"), HasSubstr("VP"), HasSubstr("FV"),
                          HasSubstr("omnidirectional"), HasSubstr("viewport"))))
        << text.id;
  }
}

/// A protocol that replaces every text by its own id, with the names in braces that it has.
Texts ids_as_texts() {
  Texts texts;
  for (const BuiltInText& text : built_in_texts()) {
    std::string words = "<" + std::string(text.id) + ">";
    for (const std::string& name : names_in(text.english)) {
      words += " {" + name + "}";
    }
    texts[std::string(text.id)] = words;
  }
  return texts;
}

TEST(WordsTest, AllWordsAreTheProtocols) {
  for (const ScreenPage& screen : plain_screens(ids_as_texts())) {
    for (const std::string& words : words_on(screen)) {
      if (!words.empty()) {
        EXPECT_EQ(words.front(), '<') << words;
      }
    }
  }
}

TEST(WordsTest, EveryTextIsShownSomewhere) {
  const Texts texts = ids_as_texts();
  std::string shown;
  const auto show = [&](const ScreenPage& screen) {
    for (const std::string& words : words_on(screen)) {
      shown += words + '\n';
    }
    for (const ScreenField& field : screen.fields) {
      shown += field.fault + '\n';
      for (const std::string& label : field.labels) {
        shown += label + '\n';
      }
    }
  };
  for (const ScreenPage& screen : plain_screens(texts)) {
    show(screen);
  }
  const auto walk = [&](Form form, std::u32string_view wrong, std::u32string_view right) {
    for (int i = 0; i < 3 && !form.is_submitted(); ++i) {
      show(form.screen());
      type(form, wrong);
      press(form, {FormKey::enter});
      show(form.screen());
      press(form, {FormKey::erase, FormKey::erase, FormKey::erase});
      type(form, right);
      press(form, {FormKey::enter});
    }
    show(form.screen());
  };
  walk(consent_form(texts), U"", U"1");
  walk(rating_form({test::experience()}, texts), U"", U"3");
  walk(questionnaire_form(
           {.title = "t", .intro = "i", .questions = {test::experience(), test::gender()}}, texts),
       U"", U"1");
  walk(questionnaire_form({.title = "t", .questions = {test::age()}}, texts), U"1", U"20");
  walk(questionnaire_form({.title = "t", .questions = {test::age()}}, texts), U"--", U"20");
  walk(questionnaire_form({.title = "t", .questions = {test::age()}}, texts), U"1,500", U"20");
  walk(questionnaire_form({.title = "t", .questions = {test::comments()}}, texts), U"", U"");
  Question many = test::experience();
  many.maximum = 100.0;
  walk(questionnaire_form({.title = "t", .questions = {many}}, texts), U"1.5", U"2");
  for (const auto& [id, words] : texts) {
    // A form offers only its options.
    if (id != "fault_no_option") {
      EXPECT_NE(shown.find("<" + id + ">"), std::string::npos) << id;
    }
  }
}

TEST(WordsTest, InAHeadsetNoKeysAreNamed) {
  const Texts texts = texts_in_headset({});
  std::vector<ScreenPage> screens = plain_screens(texts);
  for (Form form :
       {consent_form(texts), rating_form({test::experience()}, texts),
        questionnaire_form({.title = "t", .intro = "i", .questions = {test::gender()}}, texts)}) {
    screens.push_back(form.screen());
    press(form, {FormKey::enter});
    screens.push_back(form.screen());
  }
  for (const ScreenPage& screen : screens) {
    EXPECT_THAT(words_on(screen),
                Each(Not(AnyOf(HasSubstr("Enter"), HasSubstr("Space"), HasSubstr("[Tab]"),
                               HasSubstr("arrow key"), HasSubstr("Escape"), HasSubstr("digit"),
                               HasSubstr("keyboard"), HasSubstr("mouse")))))
        << screen.title;
  }
}

TEST(WordsTest, ParagraphsArePartedByEmptyLines) {
  const Texts texts = {{"pause", "One\nline.\n\nAnother.\n\n\n"}};
  EXPECT_THAT(notice_screen(Notice::pause, texts).paragraphs, ElementsAre("One line.", "Another."));
}

TEST(WordsTest, ATrialSaysWhichItIsAndWhatToMark) {
  const Texts texts = {
      {"ready_title", "{trial}/{trials}"},       {"ready", "go"},
      {"ready_mark", "{mark}) {instruction}"},   {"ready_object", "your {object}"},
      {"ready_unseen", "turn to your {object}"}, {"ready_again", "again"},
      {"ready_again_out_of_view", "unseen"},     {"ready_again_elsewhere", "elsewhere"},
      {"mark_taken", "{mark} of {marks} kept"}};
  ReadyPage page{.object = {.name = "Lamp"}, .count = {.trial = 3, .trials = 15}};
  const ScreenPage ready = ready_screen(two_marks, page, texts);
  EXPECT_EQ(ready.title, "3/15");
  EXPECT_THAT(ready.paragraphs, ElementsAre("your Lamp", "go", "1) You see its outline.",
                                            "2) You see its material."));
  page.again = TimedAgain::asked_for;
  page.object.is_in_view = false;
  const std::vector<std::string> again = ready_screen(two_marks, page, texts).paragraphs;
  EXPECT_THAT(std::vector(again.begin(), again.begin() + 4),
              ElementsAre("again", "turn to your Lamp", "go", "1) You see its outline."));
  page.again = TimedAgain::object_out_of_view;
  EXPECT_EQ(ready_screen(two_marks, page, texts).paragraphs.front(), "unseen");
  page.again = TimedAgain::gaze_elsewhere;
  EXPECT_EQ(ready_screen(two_marks, page, texts).paragraphs.front(), "elsewhere");
  EXPECT_EQ(mark_taken_screen(2, 2, texts).title, "2 of 2 kept");
  EXPECT_THAT(reaction_screen(7, {{"reaction", "{presses} times"}}).paragraphs,
              ElementsAre("7 times"));
}

TEST(WordsTest, OnlyTheSignalOfTheReactionTestIsBright) {
  EXPECT_TRUE(reaction_now_screen({}).is_signal);
  EXPECT_FALSE(reaction_wait_screen({}).is_signal);
  EXPECT_FALSE(reaction_early_screen({}).is_signal);
}

TEST(WordsTest, ConsentIsReadAndThenAgreedToOrNot) {
  for (const FormKey choice : {FormKey::down, FormKey::up}) {
    Form form = consent_form({{"consent", "It is about pictures."}});
    EXPECT_THAT(form.screen().paragraphs, ElementsAre("It is about pictures."));
    press(form, {FormKey::enter, FormKey::enter, FormKey::enter});
    EXPECT_FALSE(form.is_submitted()) << "a held Enter agrees to nothing";
    EXPECT_FALSE(type(form, U"yYnNjJ"));
    press(form, {choice, FormKey::enter});
    EXPECT_TRUE(form.is_submitted());
    EXPECT_EQ(form.answers() == consent_answers(), choice == FormKey::down)
        << "the first of the two is to agree";
  }
}

}  // namespace
}  // namespace foveola::study
