#include "renderer/progressive/first_look.h"

#include "renderer/progressive/loaded_scene.h"
#include "renderer/stability/shapes.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

const FieldOfView usual{.horizontal_deg = 60.0, .vertical_deg = 36.0, .lens = {}};

Scene boxes_at(const std::vector<float>& places) {
  Scene scene;
  scene.materials = {matte(Rgb(0.5F))};
  for (const float x : places) {
    scene.meshes.push_back(inside_out(inward_box({x, 0, 0}, x < 0.0F ? 1.0F : 2.0F, 0)));
  }
  return scene;
}

std::vector<std::string> notes_on(const Scene& scene) {
  const Workers workers;
  const RayScene rays(scene, workers);
  return notes_on_standpoint(scene, rays, choose_standpoint(scene, rays, usual), usual);
}

TEST(FirstLook, TellsWhatIsMissingAndWhatMendsIt) {
  EXPECT_THAT(lacks_of(Scene{}, false), ElementsAre(HasSubstr("export its objects as meshes"),
                                                    HasSubstr("--environment 1,1,1")));
  EXPECT_THAT(lacks_of(boxes_at({0}), false), ElementsAre(HasSubstr("--environment 1,1,1 of")));
  Scene lit = boxes_at({0});
  lit.lights.resize(1);
  EXPECT_THAT(lacks_of(lit, false), IsEmpty());
}

TEST(FirstLook, AnUnlitSceneIsShownInAStudioLightWhereThatIsWanted) {
  const Workers workers;
  const LoadedScene dark({}, boxes_at({0}), workers);
  EXPECT_FALSE(dark.scene.environment);
  const LoadedScene studio({}, boxes_at({0}), workers, {.lights_unlit = true});
  ASSERT_TRUE(studio.scene.environment);
  EXPECT_GT(studio.scene.environment->map.front().g, studio.scene.environment->map.back().g);
  EXPECT_THAT(studio.warnings, Contains(HasSubstr("is shown in a studio light")));
  Scene lit = boxes_at({0});
  lit.lights.resize(1);
  EXPECT_FALSE(LoadedScene({}, lit, workers, {.lights_unlit = true}).scene.environment);
}

TEST(FirstLook, AsksForLightsWithinWhereNoneComesIn) {
  EXPECT_THAT(lacks_of(boxes_at({0}), true), ElementsAre(HasSubstr("export lights in it")));
}

TEST(FirstLook, TellsTheOptionsThatLookAsItDoes) {
  Scene scene = boxes_at({0});
  scene.origin = {1000.0, 0.0, 0.0};
  const std::vector<std::string> notes = notes_on(scene);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], HasSubstr("from outside with all of it in the picture"));
  EXPECT_THAT(notes[0], HasSubstr("that is --camera 1004,2.773,8.172 --head -30,-20,"));
}

TEST(FirstLook, TellsThatThingsAreFarApartAndWhereOneOfThemIs) {
  EXPECT_THAT(notes_on(boxes_at({-10, 10})), ElementsAre(Not(HasSubstr("far apart"))));
  EXPECT_THAT(
      notes_on(boxes_at({-500, 500})),
      ElementsAre(HasSubstr("seen from outside"),
                  AllOf(HasSubstr("far apart"), HasSubstr("--camera -497.8,1.387,4.086 "))));
}

TEST(FirstLook, SaysNothingOfWhereOneStandsInNothing) { EXPECT_THAT(notes_on(Scene{}), IsEmpty()); }

}  // namespace
}  // namespace foveola::test
