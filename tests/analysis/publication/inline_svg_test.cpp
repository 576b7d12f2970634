#include "analysis/publication/inline_svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foveola::analysis {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* drawing =
    "<?xml version=\"1.0\"?>\n<svg viewBox=\"0 0 9 9\"><title>Gnuplot</title>"
    "<rect fill=\"#ffffff\"/><circle id='gpPt6'/><use xlink:href='#gpPt6' "
    "color='rgb( 11, 106, 168)'/><text fill=\"black\">rgb(11,106,168) \"black\" id='x'</text>"
    "<path stroke='rgb(1,2,3)'/></svg>";

TEST(InlineSvg, HasARoleAndAnEscapedName) {
  const std::string svg = inline_svg(drawing, "fig", "Times of \"<hall>\"");
  EXPECT_THAT(svg,
              StartsWith("<svg role=\"img\" aria-label=\"Times of &quot;&lt;hall&gt;&quot;\" "));
  EXPECT_THAT(svg, Not(HasSubstr("<title>")));
}

TEST(InlineSvg, TakesThePagesColors) {
  const std::string svg = inline_svg(drawing, "fig", "");
  EXPECT_THAT(svg, HasSubstr("color='var(--figure-method-1)'"));
  EXPECT_THAT(svg, HasSubstr("<rect fill=\"none\"/>"));
  EXPECT_THAT(svg, HasSubstr("<text fill=\"var(--figure-ink)\">"));
  EXPECT_THAT(svg, HasSubstr("stroke='rgb(1,2,3)'"));
}

TEST(InlineSvg, IdsAreItsOwn) {
  const std::string svg = inline_svg(drawing, "fig", "");
  EXPECT_THAT(svg, HasSubstr("id='fig-gpPt6'"));
  EXPECT_THAT(svg, HasSubstr("href='#fig-gpPt6'"));
}

TEST(InlineSvg, TextStaysAsItIs) {
  EXPECT_THAT(inline_svg(drawing, "fig", ""), HasSubstr(">rgb(11,106,168) \"black\" id='x'<"));
}

TEST(InlineSvg, DamagedInputEndsToo) {
  EXPECT_NO_THROW((void)inline_svg("", "fig", ""));
  EXPECT_NO_THROW((void)inline_svg("<svg <title>rgb(", "fig", ""));
}

}  // namespace
}  // namespace foveola::analysis
