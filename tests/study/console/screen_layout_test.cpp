#include "study/console/screen_layout.h"

#include <algorithm>

#include "renderer/base/text/utf8.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

using ::testing::Field;

const std::vector<std::string> said = {"   1.000 s  The first.", "   2.000 s  The second."};

class ScreenLayout : public ::testing::Test {
 protected:
  std::vector<std::string> lines(const ScreenSize& size) const {
    std::vector<std::string> texts;
    for (const ScreenLine& line : lay_out_screen(content_, size)) {
      texts.push_back(line.text);
    }
    return texts;
  }

  ScreenContent content_{.status = {.participant = "P07",
                                    .time = std::chrono::seconds(3723),
                                    .now = "marking, trial 3 of 15: arcade with fv",
                                    .then = "trial 4 of 15: arcade with od",
                                    .next_key = "Space marks outline",
                                    .frames = {.rate_hz = 60.0, .refresh_rate_hz = 60.0},
                                    .gaze = {.eye = "tracked", .valid = 1.0, .age_s = 0.012},
                                    .last_mark = ""},
                         .said = said};
};

TEST_F(ScreenLayout, SaysHowTheSessionStands) {
  EXPECT_THAT(lines({.columns = 60, .rows = 12}),
              ElementsAre(" Foveola, participant P07                           1:02:03 ",
                          " now        marking, trial 3 of 15: arcade with fv",
                          " then       trial 4 of 15: arcade with od",
                          " next key   Space marks outline", " frames     60.0 a second of 60",
                          " gaze       tracked; 100 % valid, the newest 12 ms old",
                          " last mark  none yet", "", "    1.000 s  The first.",
                          "    2.000 s  The second.", "", StartsWith(" state  next  note  pause")));
}

TEST_F(ScreenLayout, WarningsStandAboveWhatWasSaid) {
  content_.status.warnings = {{WarningKind::no_gaze, "The eye tracker sends no gaze at all."}};
  const std::vector<ScreenLine> screen = lay_out_screen(content_, {.columns = 30, .rows = 24});
  const auto warning = std::find_if(screen.begin(), screen.end(), [](const ScreenLine& line) {
    return line.look == LineLook::warning;
  });
  ASSERT_LT(warning + 4, screen.end());
  EXPECT_EQ(warning[0].text, " ! The eye tracker sends no");
  EXPECT_EQ(warning[1].text, "   gaze at all.");
  EXPECT_EQ(warning[1].look, LineLook::warning);
  EXPECT_EQ(warning[3].text, "    1.000 s  The first.");
}

TEST_F(ScreenLayout, WhatIsNoPersonsEyeStandsOut) {
  content_.status.gaze.eye = "simulated";
  EXPECT_THAT(lay_out_screen(content_, {}),
              Contains(AllOf(Field(&ScreenLine::text, HasSubstr("THE EYE IS SIMULATED")),
                             Field(&ScreenLine::look, LineLook::warning))));
}

TEST_F(ScreenLayout, OfWhatWasSaidTheNewestStays) {
  const std::vector<std::string> screen = lines({.columns = 60, .rows = 10});
  EXPECT_THAT(screen, Contains(HasSubstr("The second.")));
  EXPECT_THAT(screen, Not(Contains(HasSubstr("The first."))));
}

TEST_F(ScreenLayout, WhatIsTypedStandsInPlaceOfTheCommandsInAsManyRowsAsItTakes) {
  content_.typed = "note the phone rang";
  std::vector<ScreenLine> screen = lay_out_screen(content_, {.columns = 20, .rows = 24});
  ASSERT_EQ(screen.size(), 24U);
  EXPECT_EQ(screen[20].text, " > note the phone");
  EXPECT_EQ(screen[20].look, LineLook::typed);
  EXPECT_EQ(screen[21].text, "   rang_   (Enter");
  EXPECT_EQ(screen[22].text, "   does it, Escape");
  EXPECT_EQ(screen[23].text, "   clears it)");
  screen = lay_out_screen(content_, {.columns = 20, .rows = 1});
  EXPECT_EQ(screen.back().text, "   clears it)");
}

TEST_F(ScreenLayout, FillsAnySize) {
  content_.status.now = "die Prüfung der Gläser, trial 3 of 15: Halle mit fv";
  content_.status.warnings = {{WarningKind::no_gaze, std::string(200, 'w')}};
  for (std::size_t columns = 1; columns < 100; columns += 7) {
    for (std::size_t rows = 1; rows < 40; ++rows) {
      const std::vector<std::string> screen = lines({.columns = columns, .rows = rows});
      ASSERT_EQ(screen.size(), rows) << columns;
      for (const std::string& line : screen) {
        ASSERT_LE(count_characters(line), columns) << line;
      }
    }
  }
}

TEST(Wrapped, BreaksAtSpacesIfThereAreAny) {
  EXPECT_THAT(wrapped("one two three", 8), ElementsAre("one two", "three"));
  EXPECT_THAT(wrapped("one two", 7), ElementsAre("one two"));
  EXPECT_THAT(wrapped("abcdefgh ij", 3), ElementsAre("abc", "def", "gh", "ij"));
  EXPECT_THAT(wrapped("äöü äöü", 3), ElementsAre("äöü", "äöü"));
  EXPECT_THAT(wrapped("", 3), IsEmpty());
  EXPECT_THAT(wrapped("text", 0), IsEmpty());
}

}  // namespace
}  // namespace foveola::study
