#include "study/protocol/texts.h"

#include <set>

#include "study/protocol/built_in_texts.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

TEST(Texts, AreTheProtocolsOverTheBuiltInOnes) {
  EXPECT_EQ(text_of({}, "welcome_title"), "Welcome");
  EXPECT_EQ(text_of({{"welcome_title", "Tervetuloa"}}, "welcome_title"), "Tervetuloa");
  EXPECT_EQ(text_of({{"welcome_title", ""}}, "welcome_title"), "") << "is a choice too";
}

TEST(Texts, HaveNoIdTwice) {
  const std::vector<std::string> ids = known_text_ids();
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size());
}

TEST(Texts, OfAHeadsetTakeThePlaceOfBuiltInOnesAlone) {
  const Texts texts = texts_in_headset({{"ready_keys", "[Laukaisin]"}});
  EXPECT_EQ(text_of(texts, "ready_keys"), "[Laukaisin]") << "the protocol's";
  EXPECT_EQ(text_of(texts, "reaction_now_keys"), "[mark]");
  EXPECT_EQ(text_of(texts, "welcome_title"), "Welcome");
}

TEST(Texts, OfAHeadsetFillInTheSameNames) {
  for (const BuiltInText& text : built_in_texts_in_headset()) {
    EXPECT_EQ(names_in(text.english), names_in(text_of({}, text.id))) << text.id;
    EXPECT_NE(text.english, text_of({}, text.id));
  }
}

TEST(NamesIn, AreThoseInBraces) {
  EXPECT_THAT(names_in("{trial} of {trials}"), ElementsAre("trial", "trials"));
  EXPECT_THAT(names_in("none"), IsEmpty());
  EXPECT_THAT(names_in("open { and"), IsEmpty());
  EXPECT_THAT(names_in("} {a}"), ElementsAre("a"));
}

TEST(Filled, ReplacesTheNamesThatItKnows) {
  EXPECT_EQ(filled("{trial} of {trials}", {{"trial", "3"}, {"trials", "12"}}), "3 of 12");
  EXPECT_EQ(filled("{trial}{trial}", {{"trial", "3"}}), "33");
  EXPECT_EQ(filled("{other} {trial", {{"trial", "3"}}), "{other} {trial");
  EXPECT_EQ(filled("{{trial}}", {{"trial", "3"}}), "{3}");
  EXPECT_EQ(filled("", {{"trial", "3"}}), "");
  EXPECT_EQ(filled("{trial}", {{"trial", "{trial}"}}), "{trial}") << "and not for ever";
}

}  // namespace
}  // namespace foveola::study
