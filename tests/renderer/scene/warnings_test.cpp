#include "renderer/scene/warnings.h"

#include "tests/matchers.h"

namespace foveola {
namespace {

TEST(Warnings, SaysEachKindOnceInOrder) {
  Warnings warnings;
  warnings.add("points are skipped", "meshes[1]");
  warnings.add("lamps are dark");
  warnings.add("faces are lost", "", 4);
  warnings.add("points are skipped", "meshes[7]", 5);
  warnings.add("nothing happened", "nowhere", 0);
  warnings.add("one curtain", "meshes[2]");
  EXPECT_THAT(warnings.lines(),
              ElementsAre("points are skipped (6 times, first at meshes[1])", "lamps are dark",
                          "faces are lost (4 times)", "one curtain (meshes[2])"));
}

}  // namespace
}  // namespace foveola
