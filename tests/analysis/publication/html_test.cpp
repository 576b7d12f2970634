#include "analysis/publication/html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foveola::analysis {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Html, EscapesWhatMarkupIsMadeOf) {
  EXPECT_EQ(escape_html("<a href=\"x\">Tom & 'Ann'</a>\n"),
            "&lt;a href=&quot;x&quot;&gt;Tom &amp; &#39;Ann&#39;&lt;/a&gt; ");
}

TEST(Html, TablesNameTheirRowsAndColumns) {
  HtmlTable table;
  table.caption_html = "<strong>Times</strong>";
  table.groups = {{"", 1}, {"both", 2}};
  table.columns = {"scene", "od", "fv"};
  table.rows = {{"<hall>", "1", "2"}};
  const std::string html = render(table);
  EXPECT_THAT(html, HasSubstr("<caption><strong>Times</strong></caption>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"colgroup\" colspan=\"2\">both</th>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"col\">fv</th>"));
  EXPECT_THAT(html, HasSubstr("<th scope=\"row\">&lt;hall&gt;</th><td>1</td><td>2</td>"));
}

TEST(Html, ATableOfTextIsNotAlignedAsNumbers) {
  HtmlTable table;
  table.columns = {"who"};
  table.rows = {{"P1"}};
  EXPECT_THAT(render(table), HasSubstr("class=\"numeric\""));
  table.numeric = false;
  EXPECT_THAT(render(table), Not(HasSubstr("class=\"numeric\"")));
}

}  // namespace
}  // namespace foveola::analysis
