#include "renderer/base/numbers/aligned_rows.h"

#include <gtest/gtest.h>

namespace foveola {
namespace {

const std::vector<TextRow> rows = {{"scene", "s", "%"}, {"Küche", "12.5"}, {"hall", "3", "100"}};

TEST(AlignedRows, ColumnsAreAsWideAsTheirWidestCell) {
  EXPECT_EQ(aligned(rows), "scene  s     %\nKüche  12.5\nhall   3     100\n");
}

TEST(AlignedRows, NoCellControlsTheTerminalOrBeginsALine) {
  EXPECT_EQ(aligned({{"scene", "a\x1b[31mred"}, {"a\nb", "c"}}), "scene  a?[31mred\na b    c\n");
}

TEST(AlignedRows, NumbersAreAlignedToTheRightWhereAsked) {
  EXPECT_EQ(aligned(rows, {.indent = 2, .gap = 3, .numbers_to_the_right = true}),
            "  scene      s     %\n  Küche   12.5\n  hall       3   100\n");
}

}  // namespace
}  // namespace foveola
