#include "analysis/tables/html.h"

#include <gtest/gtest.h>

namespace foveola::analysis {
namespace {

TEST(Html, EscapesWhatMarkupIsMadeOf) {
  EXPECT_EQ(escape_html("<a href=\"x\">Tom & 'Ann'</a>\n"),
            "&lt;a href=&quot;x&quot;&gt;Tom &amp; &#39;Ann&#39;&lt;/a&gt; ");
}

}  // namespace
}  // namespace foveola::analysis
