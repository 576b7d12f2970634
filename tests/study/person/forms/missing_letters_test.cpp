#include "study/person/forms/missing_letters.h"

#include "tests/matchers.h"

namespace foveola::study {
namespace {

using testing::Field;

/// U+FDD0 and U+FDD1 are never to be characters, by Unicode: no font has them, whichever are
/// installed.
Protocol protocol_with_no_characters() {
  return read_protocol(R"(
name = "small"
title = "Small"
scenes = ["arcade"]
methods = ["od", "fv"]
[texts]
consent = "Ready \uFDD0 \uFDD1?"
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
label = "\uFDD0"
)",
                       "p.toml");
}

TEST(MissingLetters, AreFoundInEveryText) {
  const std::vector<MissingLetters> missing = missing_letters(protocol_with_no_characters());
  ASSERT_EQ(missing.size(), 2U);
  EXPECT_EQ(missing[0].key, "texts.consent");
  EXPECT_EQ(missing[0].characters, (Characters{0xFDD0, 0xFDD1}));
  EXPECT_EQ(missing[1].key, "questionnaire.you.hand");
  EXPECT_EQ(missing[1].characters, Characters{0xFDD0});
}

TEST(MissingLetters, AllThatAParticipantReadsIsLookedAt) {
  const std::vector<ShownText> texts = shown_texts(protocol_with_no_characters());
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
