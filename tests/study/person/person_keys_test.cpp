#include "study/person/person_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace foveola::study {
namespace {

std::optional<PersonKey> pressed(int key) {
  return person_key({.what = KeyMoved{.key = key, .is_down = true}});
}

std::optional<PersonKey> typed(char32_t character) {
  return person_key({.what = CharacterTyped{character}});
}

TEST(PersonKeys, LargeKeysByTheirPlace) {
  EXPECT_EQ(pressed(GLFW_KEY_SPACE), PersonKey::mark);
  EXPECT_EQ(pressed(GLFW_KEY_ENTER), PersonKey::confirm);
  EXPECT_EQ(pressed(GLFW_KEY_KP_ENTER), PersonKey::confirm);
  EXPECT_EQ(pressed(GLFW_KEY_TAB), PersonKey::next);
  EXPECT_EQ(pressed(GLFW_KEY_BACKSPACE), PersonKey::back);
  EXPECT_EQ(pressed(GLFW_KEY_ESCAPE), PersonKey::pause);
}

TEST(PersonKeys, LettersByTheLayout) {
  EXPECT_EQ(typed(U'y'), PersonKey::yes);
  EXPECT_EQ(typed(U'Y'), PersonKey::yes);
  EXPECT_EQ(typed(U'n'), PersonKey::no);
  EXPECT_EQ(typed(U'R'), PersonKey::again);
  EXPECT_EQ(pressed(GLFW_KEY_Y), std::nullopt);
  EXPECT_EQ(typed(U' '), std::nullopt);  // the space bar counts once, as a key
}

TEST(PersonKeys, AKeyThatIsLetGoMeansNothing) {
  EXPECT_EQ(person_key({.what = KeyMoved{.key = GLFW_KEY_SPACE, .is_down = false}}), std::nullopt);
}

TEST(PersonKeys, TheWindowsCrossOnlyPauses) {
  EXPECT_EQ(person_key({.what = CloseWanted{}}), PersonKey::pause);
}

TEST(PersonKeys, APressOfEachMeansIt) {
  for (int key = 0; key <= static_cast<int>(PersonKey::again); ++key) {
    const WindowEvent press = press_of(static_cast<PersonKey>(key), std::chrono::seconds(3));
    EXPECT_EQ(person_key(press), static_cast<PersonKey>(key));
    EXPECT_EQ(press.time, std::chrono::seconds(3));
  }
}

}  // namespace
}  // namespace foveola::study
