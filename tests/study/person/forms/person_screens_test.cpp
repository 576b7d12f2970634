// All that a participant sees, as it is drawn. With FOVEOLA_SCREENS=FOLDER every capture is written
// there, for people to look at.
#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "study/person/forms/confirmation.h"
#include "study/person/forms/words.h"
#include "tests/matchers.h"
#include "tests/renderer/window/screen_capture.h"
#include "tests/renderer/window/screen_letters.h"
#include "tests/study/person/forms/typing.h"

namespace foveola::study {
namespace {

struct NamedScreen {
  std::string name;
  ScreenPage screen;
};

/// Every page of a form, with an answer where one is asked for.
std::vector<NamedScreen> pages_of_form(const std::string& name, Form form) {
  std::vector<NamedScreen> pages;
  while (!form.is_submitted()) {
    test::press(form, {FormKey::right, FormKey::down});
    test::type(form, U"20");
    pages.push_back({fmt::format("{}-{:02}", name, pages.size()), form.screen()});
    EXPECT_TRUE(test::press(form, {FormKey::enter})) << name;
  }
  return pages;
}

void append(std::vector<NamedScreen>& screens, std::vector<NamedScreen> more) {
  std::move(more.begin(), more.end(), std::back_inserter(screens));
}

std::vector<Questionnaire> ready_questionnaires() {
  std::string text = "name = \"ready\"\ntitle = \"Ready\"\nscenes = [\"a\"]\nmethods = [\"od\"]\n";
  for (const char* name : {"ssq", "nasa-tlx", "sus"}) {
    text += fmt::format("[[questionnaire]]\nid = \"{0}\"\nfile = \"{0}\"\n", name);
  }
  return read_protocol(text, "ready.toml").questionnaires;
}

const NamedObject lamp{.name = "the floor lamp"};
const NamedObject unseen_lamp{.name = "the floor lamp", .is_in_view = false};

/// Of the published study's protocol and of the ready questionnaires, which are in English.
std::vector<NamedScreen> screens_of_a_session(bool in_headset) {
  const Protocol protocol = load_protocol(find_protocol("koskela2018"));
  const Texts texts = in_headset ? texts_in_headset(protocol.texts) : protocol.texts;
  std::vector<NamedScreen> screens = {
      {"reaction", reaction_screen(10, texts)},
      {"reaction-wait", reaction_wait_screen(texts)},
      {"reaction-early", reaction_early_screen(texts)},
      {"reaction-now", reaction_now_screen(texts)},
      {"choosing", choosing_screen(lamp, texts)},
      {"ready", ready_screen(protocol.marks, {.object = lamp, .count = {3, 15}}, texts)},
      {"ready-again",
       ready_screen(
           protocol.marks,
           {.object = unseen_lamp, .count = {15, 15}, .again = TimedAgain::object_out_of_view},
           texts)},
      {"no-gaze", no_gaze_screen(texts)},
      {"mark-taken", mark_taken_screen(1, protocol.marks.size(), texts)},
      {"look-around", look_around_screen(texts)},
      {"retiming", Confirmation(Confirmed::timing_again, texts).screen(texts)},
      {"stopping", Confirmation(Confirmed::stopping, texts).screen(texts)}};
  for (int notice = 0; notice <= static_cast<int>(Notice::goodbye); ++notice) {
    screens.push_back(
        {fmt::format("notice-{:02}", notice), notice_screen(static_cast<Notice>(notice), texts)});
    screens.back().screen.progress = 0.3;
  }
  Texts with_consent = texts;
  with_consent["consent"] =
      "This study is about previews of pictures that a computer paints. You will look at scenes, "
      "press keys and answer questions.\n\nTaking part is voluntary: you may stop at any time and "
      "need not say why, and what was recorded of you can then be deleted.\n\nYour answers, the "
      "times at which you press keys and where you look are kept under a code, never under your "
      "name. They are published without the code.\n\nSome people feel unwell while wearing a "
      "headset: then say so, and take it off at once.";
  append(screens, pages_of_form("consent", consent_form(with_consent)));
  append(screens, pages_of_form("rating", rating_form(protocol.ratings, texts)));
  for (const std::vector<Questionnaire>& questionnaires :
       {protocol.questionnaires, ready_questionnaires()}) {
    for (const Questionnaire& questionnaire : questionnaires) {
      append(screens, pages_of_form(questionnaire.id, questionnaire_form(questionnaire, texts)));
    }
  }
  return screens;
}

std::vector<NamedScreen> screens_of_sessions() {
  std::vector<NamedScreen> screens = screens_of_a_session(false);
  append(screens, screens_of_a_session(true));
  return screens;
}

class PersonScreensFit : public ::testing::TestWithParam<foveola::test::PlaceCase> {};

TEST_P(PersonScreensFit, WithoutOverlapAndWithoutLeavingAnythingOut) {
  const ScreenPlace& place = GetParam().place;
  const foveola::test::ScreenLetters letters(text_height_px(place));
  for (const auto& [name, screen] : screens_of_sessions()) {
    SCOPED_TRACE(name);
    const ScreenLayout layout = lay_out(screen, place, letters.width());
    for (const PlacedShape& shape : layout.shapes) {
      EXPECT_NE(shape.kind, PlacedShape::Kind::triangle_up);
      EXPECT_NE(shape.kind, PlacedShape::Kind::triangle_down);
    }
    for (std::size_t i = 0; i < layout.texts.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_FALSE(foveola::test::overlap(layout.texts[i].rect, layout.texts[k].rect))
            << layout.texts[i].line << " / " << layout.texts[k].line;
      }
    }
  }
}

TEST_P(PersonScreensFit, WordsOverAPictureLeaveItsMiddleFree) {
  const ScreenPlace& place = GetParam().place;
  const foveola::test::ScreenLetters letters(text_height_px(place));
  const ScreenRect& page = place.page;
  const float middle_px = 0.5F * (page.low.y + page.high.y);
  const float free_px = 0.05F * page.size().y;
  for (const auto& [name, screen] : screens_of_sessions()) {
    if (screen.covers_picture || !screen.fields.empty()) {
      continue;
    }
    for (const PlacedShape& shape : lay_out(screen, place, letters.width()).shapes) {
      EXPECT_TRUE(shape.rect.high.y < middle_px - free_px || shape.rect.low.y > middle_px + free_px)
          << name << ": from " << shape.rect.low.y << " to " << shape.rect.high.y << " of "
          << page.size().y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Places, PersonScreensFit,
                         ::testing::ValuesIn(foveola::test::place_cases()),
                         [](const auto& one) { return std::string(one.param.name); });

class PersonScreensDrawn : public ::testing::TestWithParam<foveola::test::WindowCase> {};

TEST_P(PersonScreensDrawn, InsideTheWindow) {
  if (GetParam().size.x > 1280 && std::getenv("FOVEOLA_SCREENS") == nullptr) {
    GTEST_SKIP() << "takes minutes where the processor draws: only for FOVEOLA_SCREENS";
  }
  foveola::test::ScreenCapture screens(GetParam());
  for (const auto& [name, screen] : screens_of_a_session(false)) {
    const RgbImage picture = screens.capture(screen);
    foveola::test::keep_for_people(fmt::format("study-{}-{}", GetParam().name, name), picture);
    if (screen.covers_picture) {
      const Ink ground = screen.is_signal ? Ink::text : Ink::ground;
      EXPECT_EQ(foveola::test::strangers_in_margin(picture, ground), 0) << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Windows, PersonScreensDrawn,
                         ::testing::ValuesIn(foveola::test::window_cases),
                         [](const auto& one) { return fmt::format("Window{}", one.param.name); });

}  // namespace
}  // namespace foveola::study
