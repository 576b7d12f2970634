#include "analysis/publication/report/report_parts.h"
#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

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

TEST(InlineSvg, TakesThePagesColorsAndHasIdsOfItsOwn) {
  const std::string svg = inline_svg(drawing, "fig", "");
  for (const char* part :
       {"color='var(--figure-method-1)'", "<rect fill=\"none\"/>",
        "<text fill=\"var(--figure-ink)\">", "stroke='rgb(1,2,3)'", "id='fig-gpPt6'",
        "href='#fig-gpPt6'", ">rgb(11,106,168) \"black\" id='x'<"}) {
    EXPECT_THAT(svg, HasSubstr(part));
  }
}

TEST(InlineSvg, DamagedInputEndsToo) {
  EXPECT_NO_THROW((void)inline_svg("", "fig", ""));
  EXPECT_NO_THROW((void)inline_svg("<svg <title>rgb(", "fig", ""));
}

}  // namespace
}  // namespace foveola::analysis
