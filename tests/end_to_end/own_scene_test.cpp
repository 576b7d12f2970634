// A study of a user's own scene.
#include "tests/end_to_end/own_scene.h"

#include "tests/matchers.h"

namespace foveola::test {
namespace {

TEST_F(OwnScene, IsShownAsTheDescriptorBesideItSays) {
  const ProgramResult result = succeeded(
      run({"render", path("kitchen.glb"), "-o", path("x.png"), "--size", "16x8", "--spp", "1"}));
  EXPECT_THAT(result.errors, HasSubstr("kitchen.glb is shown as kitchen.toml beside it says"));
}

TEST_F(OwnScene, IsFoundBesideTheProtocol) {
  const ProgramResult checked = succeeded(run({"study", "check", path("study.toml")}));
  EXPECT_THAT(checked.output, AllOf(HasSubstr("kitchen"), HasSubstr("Stove")));
  succeeded(simulate());
}

TEST_F(OwnScene, AChangedDescriptorIsAnotherScene) {
  succeeded(simulate());
  write("kitchen.toml", descriptor("Fridge"));
  const ProgramResult refused = run({"study", "simulate", path("study.toml"), "--db",
                                     path("study.sqlite"), "--participants", "2"});
  expect_one_line(refused, 1, "kitchen");
  EXPECT_THAT(refused.errors, AllOf(HasSubstr("Stove"), HasSubstr("Fridge")));
}

TEST_F(OwnScene, WithoutObjectsIsToldHowToGetThem) {
  write("kitchen.toml", "title = \"Not a descriptor\"\n");
  const ProgramResult result = run({"study", "check", path("study.toml")});
  expect_one_line(result, 1, "study.toml:3:11");
  EXPECT_THAT(result.errors, HasSubstr("foveola scene describe"));
}

}  // namespace
}  // namespace foveola::test
