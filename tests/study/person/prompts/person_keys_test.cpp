#include "study/person/prompts/person_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace foveola::study {
namespace {

std::optional<PersonKey> pressed(int key) {
  return person_key({.what = KeyMoved{.key = key, .is_down = true}});
}

TEST(PersonKeys, LargeKeysByTheirPlace) {
  EXPECT_EQ(pressed(GLFW_KEY_SPACE), PersonKey::mark);
  EXPECT_EQ(pressed(GLFW_KEY_ENTER), PersonKey::confirm);
  EXPECT_EQ(pressed(GLFW_KEY_KP_ENTER), PersonKey::confirm);
  EXPECT_EQ(pressed(GLFW_KEY_TAB), PersonKey::next);
  EXPECT_EQ(pressed(GLFW_KEY_BACKSPACE), PersonKey::back);
  EXPECT_EQ(pressed(GLFW_KEY_ESCAPE), PersonKey::pause);
}

TEST(PersonKeys, NoLetterMeansAnything) {
  for (int key = GLFW_KEY_A; key <= GLFW_KEY_Z; ++key) {
    EXPECT_EQ(pressed(key), std::nullopt);
  }
  for (const char32_t typed : {U'y', U'N', U'r', U'н', U' '}) {
    EXPECT_EQ(person_key({.what = CharacterTyped{typed}}), std::nullopt);
  }
}

TEST(PersonKeys, AKeyThatIsLetGoMeansNothing) {
  EXPECT_EQ(person_key({.what = KeyMoved{.key = GLFW_KEY_SPACE, .is_down = false}}), std::nullopt);
}

TEST(PersonKeys, TheWindowsCrossOnlyPauses) {
  EXPECT_EQ(person_key({.what = CloseWanted{}}), PersonKey::pause);
}

TEST(PersonKeys, APressOfEachMeansIt) {
  for (int key = 0; key <= static_cast<int>(PersonKey::pause); ++key) {
    const WindowEvent press = make_press(static_cast<PersonKey>(key), std::chrono::seconds(3));
    EXPECT_EQ(person_key(press), static_cast<PersonKey>(key));
    EXPECT_EQ(press.time, std::chrono::seconds(3));
  }
}

}  // namespace
}  // namespace foveola::study
