#include "study/console/console_command.h"
#include "study/console/screen_layout.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

constexpr TypedKey enter{TypedKey::Kind::enter};
constexpr TypedKey escape{TypedKey::Kind::escape};
constexpr TypedKey erase{TypedKey::Kind::erase};

class CommandEntryTest : public ::testing::Test {
 protected:
  /// No key but Enter may end the line.
  void type(const std::u32string& characters, bool is_pasted = false) {
    for (const char32_t character : characters) {
      EXPECT_FALSE(entry_.follow({.character = character, .is_pasted = is_pasted}));
    }
  }
  std::optional<EnteredLine> press(const TypedKey& key) { return entry_.follow(key); }
  std::string end() { return press(enter).value().text; }

  CommandEntry entry_;
};

TEST_F(CommandEntryTest, OnlyEnterEndsALine) {
  type(U"nthe phüö");
  press(erase);
  press(erase);
  type(U"one");
  EXPECT_EQ(entry_.typed(), "nthe phone");
  EXPECT_EQ(end(), "nthe phone");
  EXPECT_EQ(entry_.typed(), "");
}

// What was typed into the wrong window, by people who meant no command: the first of each line was
// a key of the console's once.
TEST_F(CommandEntryTest, SentencesAskForNothing) {
  for (const std::u32string sentence :
       {U"The view was nice", U"The exit was dark", U"people", U"yes", U"p", U"w", U"x", U"q",
        U"withdraw", U"withdraw, please", U"exclude", U"quite dark", U"pauses"}) {
    type(sentence);
    EXPECT_FALSE(parse_console_line(end()));
  }
}

TEST_F(CommandEntryTest, EscapeClearsTheLine) {
  type(U"pause");
  EXPECT_FALSE(press(escape));
  EXPECT_EQ(end(), "");
  press(erase);
  EXPECT_EQ(entry_.typed(), "");
}

TEST_F(CommandEntryTest, WhatIsPastedIsKnownAndEndsNoLine) {
  type(U"with", true);
  EXPECT_FALSE(press({.kind = TypedKey::Kind::enter, .is_pasted = true}));
  type(U"draw");
  const std::optional<EnteredLine> line = press(enter);
  EXPECT_EQ(line->text, "with draw");
  EXPECT_TRUE(line->is_pasted);
  type(U"pause");
  EXPECT_FALSE(press(enter)->is_pasted) << "the next line is another";
  type(U"x", true);
  press(erase);
  type(U"pause");
  EXPECT_FALSE(press(enter)->is_pasted) << "nothing of the paste is left";
}

}  // namespace
}  // namespace foveola::study
