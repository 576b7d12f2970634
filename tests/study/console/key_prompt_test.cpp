#include "study/console/key_prompt.h"

#include <gmock/gmock.h>

#include "study/console/console_command.h"

namespace foveola::study {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr TypedKey enter{TypedKey::Kind::enter};
constexpr TypedKey escape{TypedKey::Kind::escape};
constexpr TypedKey erase{TypedKey::Kind::erase};

class KeyPromptTest : public ::testing::Test {
 protected:
  /// What the keys ask for; none may before the last.
  std::optional<std::string> type(const std::u32string& characters) {
    std::optional<std::string> line;
    for (const char32_t character : characters) {
      EXPECT_EQ(line, std::nullopt);
      line = prompt_.follow({.character = character}, is_paused_);
    }
    return line;
  }
  std::optional<std::string> press(const TypedKey& key) { return prompt_.follow(key, is_paused_); }

  KeyPrompt prompt_;
  bool is_paused_ = false;
};

TEST_F(KeyPromptTest, APauseBeginsAndEndsAtOnce) {
  EXPECT_EQ(type(U"p"), "pause");
  is_paused_ = true;
  EXPECT_EQ(type(U"p"), "resume");
}

TEST_F(KeyPromptTest, ANoteIsTypedFirst) {
  EXPECT_EQ(type(U"nthe phüö"), std::nullopt);
  EXPECT_THAT(prompt_.question(), HasSubstr("the phüö_"));
  press(erase);
  press(erase);
  EXPECT_EQ(type(U"one"), std::nullopt);
  EXPECT_EQ(press(enter), "note the phone");
  EXPECT_THAT(prompt_.question(), IsEmpty());
}

TEST_F(KeyPromptTest, KeysThatAreCommandsElsewhereAreLettersInANote) {
  EXPECT_EQ(type(U"npq?"), std::nullopt);
  EXPECT_EQ(press(enter), "note pq?");
}

TEST_F(KeyPromptTest, ANoteOfNothingIsNone) {
  type(U"n");
  press(erase);
  EXPECT_EQ(press(enter), std::nullopt);
  EXPECT_THAT(prompt_.question(), IsEmpty());
}

TEST_F(KeyPromptTest, WhatEndsASessionIsConfirmed) {
  for (const auto& [key, line] :
       {std::pair{U"q", "quit"}, std::pair{U"w", "withdraw"}, std::pair{U"r", "retime"}}) {
    EXPECT_EQ(type(key), std::nullopt);
    EXPECT_THAT(prompt_.question(), HasSubstr("Escape: no"));
    EXPECT_EQ(type(key), std::nullopt) << "twice is a slip, too";
    EXPECT_EQ(press(escape), std::nullopt);
    EXPECT_THAT(prompt_.question(), IsEmpty());
    type(key);
    EXPECT_EQ(press(enter), line);
  }
}

TEST_F(KeyPromptTest, AnExclusionNeedsItsReason) {
  type(U"x");
  EXPECT_EQ(press(enter), std::nullopt);
  type(U"xsees double");
  EXPECT_EQ(press(escape), std::nullopt);
  type(U"xsees double");
  EXPECT_EQ(press(enter), "exclude sees double");
}

TEST_F(KeyPromptTest, OtherKeysDoNothing) {
  EXPECT_EQ(type(U"zP1 "), std::nullopt);
  EXPECT_EQ(press(enter), std::nullopt);
  EXPECT_EQ(press(erase), std::nullopt);
  EXPECT_THAT(prompt_.question(), IsEmpty());
}

TEST_F(KeyPromptTest, WhatKeysAskForIsUnderstood) {
  for (const std::string line :
       {"pause", "resume", "retime", "note a", "exclude a", "withdraw", "quit"}) {
    EXPECT_TRUE(parse_console_line(line)) << line;
  }
}

TEST_F(KeyPromptTest, HelpNamesEveryKey) {
  EXPECT_EQ(key_help().size(), 6U);
  for (const char* const name :
       {"p pause", "r retime", "n note", "x exclude", "w withdraw", "q quit", "? help"}) {
    EXPECT_THAT(key_names(false), HasSubstr(name));
  }
  EXPECT_THAT(key_names(true), HasSubstr("p resume"));
}

}  // namespace
}  // namespace foveola::study
