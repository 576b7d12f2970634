#include "study/person/missing_letters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foveola::study {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

/// Of nobody's letters, by Unicode: U+E000 to U+F8FF are for private use.
Protocol protocol_with_private_letters() {
  return read_protocol(R"(
name = "small"
title = "Small"
scenes = ["arcade"]
methods = ["od", "fv"]
[texts]
consent = "Ready \uE123 \uE124?"
[[questionnaire]]
id = "you"
title = "You, Ζωή, Žižkov"
[[questionnaire.question]]
id = "hand"
text = "Which hand?"
kind = "choice"
[[questionnaire.question.options]]
label = "left"
[[questionnaire.question.options]]
label = "\uE123"
)",
                       "p.toml");
}

TEST(MissingLetters, AreFoundInEveryText) {
  const std::vector<MissingLetters> missing = missing_letters(protocol_with_private_letters());
  ASSERT_EQ(missing.size(), 2U);
  EXPECT_EQ(missing[0].key, "texts.consent");
  EXPECT_EQ(missing[0].characters, (Characters{0xE123, 0xE124}));
  EXPECT_EQ(missing[1].key, "questionnaire.you.hand");
  EXPECT_EQ(missing[1].characters, Characters{0xE123});
}

TEST(MissingLetters, AllThatAParticipantReadsIsLookedAt) {
  const std::vector<ShownText> texts = shown_texts(protocol_with_private_letters());
  for (const char* key : {"texts.consent", "mark.outline", "rating.artifacts", "questionnaire.you",
                          "questionnaire.you.hand"}) {
    EXPECT_THAT(texts, Contains(Field(&ShownText::key, key)));
  }
}

TEST(MissingLetters, AWarningSaysWhichWhereAndWhatToDo) {
  EXPECT_THAT(warning_of({"texts.consent", {0x3042, 0x732B}}),
              AllOf(HasSubstr("texts.consent: "), HasSubstr("あ (U+3042), 猫 (U+732B)"),
                    HasSubstr("fonts-noto-cjk")));
  EXPECT_THAT(warning_of({"texts.pause", {0x0F40}}), HasSubstr("fonts-noto-core"));
  EXPECT_THAT(warning_of({"texts.pause", {0xE123}}), HasSubstr("other characters"));
}

TEST(MissingLetters, OfEuropesThereAreNone) {
  EXPECT_THAT(missing_letters(load_protocol(find_protocol("koskela2018"))), IsEmpty());
}

}  // namespace
}  // namespace foveola::study
