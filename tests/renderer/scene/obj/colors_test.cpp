#include "renderer/scene/obj/colors.h"

#include "tests/matchers.h"

namespace foveola::test {
namespace {

TEST(ObjColors, FollowTheCoordinates) {
  EXPECT_THAT(vertex_colors_in("v 1 2 3 0 1 0\nv 1 2 3\r\nvn 0 0 1\nv 1 2 3 1 0 0 # red\n"),
              ElementsAre(Rgb(0, 1, 0), Rgb(1, 1, 1), Rgb(1, 0, 0)));
  EXPECT_THAT(vertex_colors_in("v 1 2 3\nv 1 2 3 1\nv 1 2 3 x y z\n"), IsEmpty());
}

TEST(ObjColors, OutOfRangeStayAsTheyAre) {
  EXPECT_THAT(vertex_colors_in("v 1 2 3 255 -1 0\n"), ElementsAre(Rgb(255, -1, 0)));
}

/// ZBrush's comments: a mask, red, green and blue for each vertex.
TEST(ObjColors, MayBePaintedByZBrush) {
  EXPECT_THAT(
      vertex_colors_in("v 1 2 3\nv 1 2 3\nv 1 2 3\n#MRGB ffff0000FF00ff00\n#MRGB zz000000\n"),
      ElementsAre(Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(1, 1, 1)));
}

}  // namespace
}  // namespace foveola::test
