// Layouts of screens in the letters that they are drawn with.
#include "renderer/window/screens/screen_layout.h"

#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include "renderer/base/text/utf8.h"
#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/renderer/window/sample_screens.h"
#include "tests/renderer/window/screen_letters.h"

namespace foveola {
namespace {

using ::testing::Le;

using test::overlap;
using test::PlaceCase;

bool holds(const ScreenRect& outer, const ScreenRect& inner) {
  return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y && inner.high.x <= outer.high.x &&
         inner.high.y <= outer.high.y;
}

// Contrast as WCAG 2.1 defines it.
double relative_luminance(const Vec3& color) {
  const auto linear = [](double c) {
    return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
}

double contrast(Ink a, Ink b) {
  const double one = relative_luminance(color_of(a)) + 0.05;
  const double other = relative_luminance(color_of(b)) + 0.05;
  return std::max(one, other) / std::min(one, other);
}

/// What lies below the middle of a rectangle.
Ink ink_below(const ScreenLayout& layout, const ScreenRect& rect) {
  const Vec2 middle = 0.5F * (rect.low + rect.high);
  Ink below = Ink::ground;
  for (const PlacedShape& shape : layout.shapes) {
    if (shape.outline_px == 0.0F && holds(shape.rect, {middle, middle})) {
      below = shape.ink;
    }
  }
  return below;
}

class ScreenLayoutTest : public ::testing::TestWithParam<PlaceCase> {
 protected:
  ScreenLayout layout(const ScreenPage& screen) const {
    return lay_out(screen, place(), letters_.width());
  }
  const ScreenPlace& place() const { return GetParam().place; }
  float text_px() const { return text_height_px(place()); }

  test::ScreenLetters letters_{text_height_px(GetParam().place)};
};

TEST_P(ScreenLayoutTest, EverythingIsInsideThePage) {
  const float margin_px = 0.3F * text_px();
  const ScreenRect inner{place().page.low + Vec2(margin_px), place().page.high - Vec2(margin_px)};
  for (const test::SampleScreen& sample : test::sample_screens()) {
    SCOPED_TRACE(sample.name);
    const ScreenLayout placed = layout(sample.screen);
    ASSERT_FALSE(placed.texts.empty());
    for (const PlacedText& text : placed.texts) {
      EXPECT_TRUE(holds(inner, text.rect)) << text.line;
    }
    // The first shape is the ground.
    for (std::size_t i = 1; i < placed.shapes.size(); ++i) {
      EXPECT_TRUE(holds(inner, placed.shapes[i].rect)) << i;
    }
  }
}

TEST_P(ScreenLayoutTest, NoLineOverlapsAnother) {
  for (const test::SampleScreen& sample : test::sample_screens()) {
    SCOPED_TRACE(sample.name);
    const ScreenLayout placed = layout(sample.screen);
    for (std::size_t i = 0; i < placed.texts.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_FALSE(overlap(placed.texts[i].rect, placed.texts[k].rect))
            << placed.texts[i].line << " / " << placed.texts[k].line;
      }
    }
  }
}

TEST_P(ScreenLayoutTest, ShapesHoldTheirTextOrStandBesideIt) {
  for (const test::SampleScreen& sample : test::sample_screens()) {
    SCOPED_TRACE(sample.name);
    const ScreenLayout placed = layout(sample.screen);
    for (const PlacedText& text : placed.texts) {
      for (const PlacedShape& shape : placed.shapes) {
        const bool is_caret = shape.ink == Ink::focus && shape.rect.size().x < 0.2F * text_px();
        EXPECT_TRUE(is_caret || holds(shape.rect, text.rect) || !overlap(shape.rect, text.rect))
            << text.line;
      }
    }
  }
}

TEST_P(ScreenLayoutTest, TextStandsOutFromWhatIsBelow) {
  for (const test::SampleScreen& sample : test::sample_screens()) {
    SCOPED_TRACE(sample.name);
    const ScreenLayout placed = layout(sample.screen);
    for (const PlacedText& text : placed.texts) {
      EXPECT_GE(contrast(text.ink, ink_below(placed, text.rect)), 7.0) << text.line;
    }
    for (const PlacedShape& shape : placed.shapes) {
      if (shape.outline_px > 0.0F) {
        EXPECT_GE(contrast(shape.ink, Ink::ground), 3.0);
      }
    }
  }
}

TEST_P(ScreenLayoutTest, LinesAreNotTooLongToReadOn) {
  for (const test::SampleScreen& sample : test::sample_screens()) {
    for (const PlacedText& text : layout(sample.screen).texts) {
      EXPECT_THAT(count_characters(text.line), Le(70U)) << text.line;
    }
  }
}

TEST_P(ScreenLayoutTest, AFullPageOfWordsIsShownWhole) {
  const std::string words = test::full_page_of_words();
  ASSERT_GE(words.size() + 1, max_screen_lines * screen_line_characters);
  const ScreenLayout placed =
      layout({.title = "Title", .paragraphs = {words}, .keys = "[Enter] next", .progress = 0.5});
  std::string shown;
  for (const PlacedText& text : placed.texts) {
    if (text.ink == Ink::text && text.face == TextFace::body) {
      shown += (shown.empty() ? "" : " ") + text.line;
    }
  }
  EXPECT_EQ(shown, words);
}

TEST_P(ScreenLayoutTest, TheFocusShowsWithoutColour) {
  const auto shapes_with = [&](ScreenField field, bool has_focus) {
    field.has_focus = has_focus;
    return layout({.title = "One", .fields = {field}}).shapes;
  };
  for (const test::SampleScreen& sample : test::sample_screens()) {
    for (const ScreenField& field : sample.screen.fields) {
      const auto is_arrow = [](const PlacedShape& shape) {
        return shape.kind == PlacedShape::Kind::triangle_right;
      };
      const auto with = shapes_with(field, true);
      const auto without = shapes_with(field, false);
      EXPECT_EQ(std::count_if(with.begin(), with.end(), is_arrow), 1) << sample.name;
      EXPECT_EQ(std::count_if(without.begin(), without.end(), is_arrow), 0) << sample.name;
    }
  }
}

TEST_P(ScreenLayoutTest, TheFieldWithTheFocusIsKeptInView) {
  for (std::size_t focused = 0; focused < 12; ++focused) {
    ScreenPage screen{.title = "Twelve", .keys = "[Enter] next", .progress = 0.5};
    for (std::size_t i = 0; i < 12; ++i) {
      screen.fields.push_back({.kind = ScreenField::Kind::line,
                               .question = fmt::format("Question {}", i),
                               .typed = fmt::format("answer {}", i),
                               .has_focus = i == focused});
    }
    const ScreenLayout placed = layout(screen);
    const auto shows = [&](const std::string& line) {
      return std::any_of(placed.texts.begin(), placed.texts.end(),
                         [&](const PlacedText& text) { return text.line == line; });
    };
    const auto has = [&](PlacedShape::Kind kind) {
      return std::any_of(placed.shapes.begin(), placed.shapes.end(),
                         [&](const PlacedShape& shape) { return shape.kind == kind; });
    };
    EXPECT_TRUE(shows(fmt::format("Question {}", focused)));
    EXPECT_TRUE(shows(fmt::format("answer {}", focused)));
    EXPECT_EQ(has(PlacedShape::Kind::triangle_up), !shows("Twelve")) << focused;
    EXPECT_EQ(has(PlacedShape::Kind::triangle_down), !shows("answer 11")) << focused;
  }
}

TEST_P(ScreenLayoutTest, ABandLeavesThePictureAbove) {
  const ScreenLayout notice = layout({.title = "Taken", .covers_picture = false});
  EXPECT_LT(notice.shapes.front().rect.size().y, 0.15F * place().page.size().y);
  const ScreenLayout scale =
      layout({.fields = {test::artifacts_scale()}, .keys = "[Enter]", .covers_picture = false});
  EXPECT_LT(scale.shapes.front().rect.size().y, 0.5F * place().page.size().y);
  for (const PlacedText& text : scale.texts) {
    EXPECT_TRUE(holds(scale.shapes.front().rect, text.rect)) << text.line;
  }
}

INSTANTIATE_TEST_SUITE_P(Places, ScreenLayoutTest, ::testing::ValuesIn(test::place_cases()),
                         [](const auto& one) { return std::string(one.param.name); });

// A 24-inch monitor of 16:9 is 0.2989 m high; DejaVu Sans' x is 1120 of 2048 units high, the em
// that a line of text_height_px holds is 1 of its ascent and descent of 1901 and 483 units (its own
// tables).
TEST(ScreenTypeTest, IsReadableAtArmsLength) {
  constexpr double x_height = 1120.0 / (1901.0 + 483.0);
  constexpr double pixel_m = 0.2989 / 1080.0;
  const double x_m = x_height * text_height_px(test::monitor(1920, 1080)) * pixel_m;
  EXPECT_NEAR(degrees(std::atan(x_m / 0.6)), 0.48, 0.01);
  const double small_window_m = x_height * text_height_px(test::monitor(1280, 720)) * pixel_m;
  EXPECT_GT(degrees(std::atan(small_window_m / 0.6)), 0.3);
}

TEST(ScreenTypeTest, IsReadableInAHeadset) {
  const double x_px = 1120.0 / (1901.0 + 483.0) * text_height_px(test::right_eye());
  const double focal_px = 640.0 / std::tan(radians(50.0));
  EXPECT_NEAR(degrees(std::atan(x_px / focal_px)), 1.2, 0.05);
}

TEST(ScreenTypeTest, AHeadsetsPageIsInTheMiddleOfTheView) {
  const ScreenPlace place = test::right_eye();
  EXPECT_EQ(place.view.low, Vec2(1280.0F, 0.0F));
  EXPECT_EQ(place.view.high, Vec2(2560.0F, 1440.0F));
  EXPECT_EQ(place.page.low, Vec2(1280.0F + 0.45F * 1280.0F - 320.0F, 360.0F));
  EXPECT_EQ(place.page.size(), Vec2(640.0F, 720.0F));
}

TEST(ScreenTypeTest, SaysWhichPackageHasTheLetters) {
  EXPECT_THAT(
      test::error_of([] { const ScreenFonts fonts("/no/such/folder"); }),
      AllOf(StartsWith("/no/such/folder/DejaVuSans.ttf: "), HasSubstr("fonts-dejavu-core")));
}

TEST(ScreenTypeTest, KnowsEuropesLetters) {
  const test::ScreenLetters letters(20.0F);
  for (const char16_t letter : std::u16string(u"aZäßéłőşΑωЖѓ€–…“”„‘’←↑→↓−ếǅ")) {
    for (const TextFace face : {TextFace::body, TextFace::title}) {
      EXPECT_NE(letters.fonts().face(face)->FindGlyphNoFallback(letter), nullptr)
          << static_cast<int>(letter);
    }
  }
}

}  // namespace
}  // namespace foveola
