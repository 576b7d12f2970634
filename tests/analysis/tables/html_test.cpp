#include "analysis/tables/html.h"

#include <gtest/gtest.h>

namespace foveola::analysis {
namespace {

TEST(Html, EscapesWhatMarkupIsMadeOf) {
  EXPECT_EQ(escape_html("<a href=\"x\">Tom & 'Ann'</a>\n"),
            "&lt;a href=&quot;x&quot;&gt;Tom &amp; &#39;Ann&#39;&lt;/a&gt; ");
}

TEST(Html, CaptionsSayWhoseDataTheyShow) {
  EXPECT_EQ(caption_html("Times & more.", ""), "<strong>Times &amp; more.</strong> ");
  EXPECT_EQ(caption_html("Times.", "Pilot data"),
            "<span class=\"tag\">Pilot data</span><strong>Times.</strong> ");
}

TEST(Html, SectionsHaveAHeading) {
  EXPECT_EQ(html_section("a < b", "<p>x</p>\n"),
            "<section>\n<h2>a &lt; b</h2>\n<p>x</p>\n</section>\n");
}

}  // namespace
}  // namespace foveola::analysis
