#include "renderer/progressive/standpoint.h"

#include <algorithm>
#include <cmath>

#include "renderer/progressive/loaded_scene.h"
#include "renderer/stability/shapes.h"
#include "tests/matchers.h"

namespace foveola::test {
namespace {

const FieldOfView picture{.horizontal_deg = 60.0, .vertical_deg = 36.0, .lens = {}};

Scene scene_of(std::vector<Mesh> meshes) {
  Scene scene;
  scene.meshes = std::move(meshes);
  scene.materials = {matte(Rgb(0.5F))};
  return scene;
}

Standpoint standpoint_in(const Scene& scene) {
  const Workers workers;
  return choose_standpoint(scene, RayScene(scene, workers), picture);
}

Mesh outward_box(const Vec3& center, float half) { return inside_out(inward_box(center, half, 0)); }

/// A box of other sides, which faces inwards.
Mesh inward_hall(const Vec3& lower, const Vec3& upper) {
  Mesh hall = inward_box(Vec3(0.5F), 0.5F, 0);
  for (Vec3& position : hall.positions) {
    position = lower + (upper - lower) * position;
  }
  return hall;
}

void expect_near(const Vec3& actual, const Vec3& expected) {
  EXPECT_NEAR(glm::distance(actual, expected), 0.0F, 1e-4F * (1.0F + glm::length(expected)));
}

/// From outside, slightly from above, with all of the meshes' vertices in the picture, which they
/// fill in at least one direction.
void expect_from_outside(const Scene& scene) {
  const Standpoint stand = standpoint_in(scene);
  EXPECT_THAT(stand.reason, HasSubstr("from outside with all"));
  EXPECT_LT(stand.heading.elevation_rad, radians(-15.0));
  EXPECT_GT(stand.heading.elevation_rad, radians(-45.0));
  const Viewport view(stand.heading, picture);
  float furthest = 0.0F;
  for (const Mesh& mesh : scene.meshes) {
    for (const Vec3& position : mesh.positions) {
      const std::optional<Vec2> plane = view.project(glm::normalize(position - stand.position));
      ASSERT_TRUE(plane);
      const Vec2 from_middle = glm::abs(2.0F * *plane - 1.0F);
      furthest = std::max({furthest, from_middle.x, from_middle.y});
    }
  }
  EXPECT_NEAR(furthest, 0.9F, 0.01F);
}

void expect_in_a_room(const Scene& scene, const Vec3& lower, const Vec3& upper) {
  const Standpoint stand = standpoint_in(scene);
  EXPECT_THAT(stand.reason, HasSubstr("of a room where it is widest"));
  EXPECT_LE(stand.heading.elevation_rad, 0.0);
  EXPECT_GE(stand.heading.elevation_rad, radians(-20.0));
  EXPECT_TRUE(glm::all(glm::greaterThan(stand.position, lower)));
  EXPECT_TRUE(glm::all(glm::lessThan(stand.position, upper)));
}

// From the front, which is +Z, and the right.
TEST(Standpoint, IsOutsideAClosedObject) {
  for (const float size : {1e-3F, 1.0F, 1e6F}) {
    const Scene box = scene_of({outward_box(Vec3(4, 5, 6) * size, size)});
    expect_from_outside(box);
    const Vec3 from_box = standpoint_in(box).position - Vec3(4, 5, 6) * size;
    EXPECT_GT(from_box.z, 0.0F);
    EXPECT_GT(from_box.x, 0.0F);
  }
}

/// In an instance that mirrors, the corners' order turns around, but not what is in front.
TEST(Standpoint, IsOutsideAMirroredInstanceToo) {
  Scene scene = scene_of({});
  scene.prototypes = {outward_box(Vec3(0.0F), 2.0F)};
  scene.instances.resize(1);
  scene.instances[0].world_from_local[0][0] = -1.0F;
  EXPECT_THAT(standpoint_in(scene).reason, HasSubstr("from outside"));
  scene.prototypes = {inward_box(Vec3(0.0F), 2.0F, 0)};
  expect_in_a_room(scene, Vec3(-2.0F), Vec3(2.0F));
}

/// A sphere without its cap, as a head without its neck, with an eye in it.
Scene head_of_size(float size) {
  Mesh head = placed(inside_out(inward_sphere(1.0F, 3, 0)), size, Quat(1, 0, 0, 0), Vec3(0.0F));
  std::erase_if(head.triangles,
                [&](const auto& corners) { return head.positions[corners[0]].y < -0.8F * size; });
  return scene_of({head, outward_box(size * Vec3(0.3F, 0.2F, 0.6F), 0.1F * size)});
}

TEST(Standpoint, IsOutsideAHead) {
  expect_from_outside(head_of_size(0.12F));
  expect_from_outside(head_of_size(120.0F));
}

/// Two skins, of which the inner one faces inwards, open below.
TEST(Standpoint, IsOutsideAHelmet) {
  for (const float size : {0.15F, 1.0F, 15.0F}) {
    Mesh outer = placed(inside_out(inward_sphere(1.0F, 3, 0)), size, Quat(1, 0, 0, 0), Vec3(0.0F));
    Mesh inner = placed(inward_sphere(1.0F, 3, 0), 0.9F * size, Quat(1, 0, 0, 0), Vec3(0.0F));
    for (Mesh* skin : {&outer, &inner}) {
      std::erase_if(skin->triangles, [&](const auto& corners) {
        return skin->positions[corners[0]].y < -0.6F * size;
      });
    }
    expect_from_outside(scene_of({outer, inner}));
  }
}

/// One skin, open at its front, where its inside is seen.
TEST(Standpoint, LooksIntoAnOpenHelmet) {
  Mesh skin = placed(inside_out(inward_sphere(1.0F, 3, 0)), 0.15F, Quat(1, 0, 0, 0), Vec3(0.0F));
  std::erase_if(skin.triangles,
                [&](const auto& corners) { return skin.positions[corners[0]].z > 0.1F; });
  const Scene helmet = scene_of({skin});
  expect_from_outside(helmet);
  EXPECT_GT(standpoint_in(helmet).position.z, 0.3F);
}

/// Its sides are of inward faces, and a bottle is too small to stand in.
TEST(Standpoint, IsOutsideABottle) {
  expect_from_outside(scene_of({outward_box(Vec3(0.0F), 0.15F), inward_box(Vec3(0.0F), 0.14F, 0)}));
}

TEST(Standpoint, IsAtEyeHeightInARoomWhereItIsWidest) {
  const Vec3 lower(-3.0F, 0.5F, -2.0F);
  const Vec3 upper(7.0F, 3.5F, 2.0F);
  const Scene scene = scene_of({inward_hall(lower, upper)});
  expect_in_a_room(scene, lower, upper);
  const Standpoint stand = standpoint_in(scene);
  expect_near(stand.position, {2.0F, 0.5F + 1.6F, 0.0F});
  EXPECT_THAT(stand.reason, HasSubstr("1.6 m above the floor"));
  // Along its length, one way or the other.
  EXPECT_NEAR(std::abs(std::sin(stand.heading.azimuth_rad)), 1.0, 0.1);
}

TEST(Standpoint, IsAtHalfTheHeightOfLowAndOfHugeRooms) {
  for (const float size : {1e-3F, 0.5F, 1e3F}) {
    const Scene scene = scene_of({inward_box({1, 2, 3}, size, 0)});
    EXPECT_THAT(standpoint_in(scene).reason, HasSubstr("half the height"));
    EXPECT_NEAR(standpoint_in(scene).position.y, 2.0F, 1e-3F * (1.0F + size));
  }
}

TEST(Standpoint, IsInARoomWithThickWalls) {
  expect_in_a_room(scene_of({inward_box({1, 2, 3}, 2.0F, 0), outward_box({1, 2, 3}, 2.5F)}),
                   Vec3(-1, 0, 1), Vec3(3, 4, 5));
}

TEST(Standpoint, IsInARoomWithoutACeiling) {
  Mesh walls = inward_hall({-3, 0, -2}, {3, 3, 2});
  std::erase_if(walls.triangles, [&](const auto& corners) {
    return std::all_of(corners.begin(), corners.end(),
                       [&](std::uint32_t corner) { return walls.positions[corner].y > 2.9F; });
  });
  expect_in_a_room(scene_of({walls}), {-3, 0, -2}, {3, 3, 2});
}

/// From 1.6 m a table of 0.5 m is below a picture that shows 18 degrees downwards, unless it is
/// far.
TEST(Standpoint, LooksDownAtWhatStandsOnTheFloorOfARoom) {
  Scene room = scene_of({inward_hall({-2, 0, -2}, {2, 2.5F, 2})});
  EXPECT_EQ(standpoint_in(room).heading.elevation_rad, 0.0);
  for (const float x : {-1.0F, 1.0F}) {
    for (const float z : {-1.0F, 1.0F}) {
      room.meshes.push_back(outward_box({x, 0.25F, z}, 0.25F));
    }
  }
  EXPECT_LE(standpoint_in(room).heading.elevation_rad, radians(-10.0));
}

/// Walls that face outwards, as whoever puts furniture into a cube leaves them.
TEST(Standpoint, IsInAFurnishedBox) {
  const Scene scene = scene_of({outward_box(Vec3(0.0F), 4.0F), outward_box({0, -2, -2}, 1.0F),
                                outward_box({2, -2, 1}, 1.0F), outward_box({-2, 0, 1}, 1.0F)});
  expect_in_a_room(scene, Vec3(-4.0F), Vec3(4.0F));
}

TEST(Standpoint, IsInABoxThatIsLitFromWithin) {
  Scene scene = scene_of({outward_box(Vec3(0.0F), 2.0F)});
  scene.lights.resize(1);
  scene.lights[0].position = {1.0F, 1.5F, 0.5F};
  expect_in_a_room(scene, Vec3(-2.0F), Vec3(2.0F));
  scene.lights[0].position = {1.0F, 4.0F, 0.5F};
  EXPECT_THAT(standpoint_in(scene).reason, HasSubstr("from outside"));
}

TEST(Standpoint, HasAllOfWhatIsOpenInThePicture) {
  expect_from_outside(scene_of({torus(2.0F, 0.5F, 32, 0)}));
  expect_from_outside(scene_of({outward_box({-3, 0, 0}, 1.0F), outward_box({3, 0, 0}, 1.0F)}));
  expect_from_outside(scene_of({outward_box({-500, 0, 0}, 1.0F), outward_box({500, 0, 0}, 1.0F)}));
}

/// Two walls and a floor, which are seen from the corner that is open, wherever it is.
TEST(Standpoint, LooksIntoAnOpenCorner) {
  for (const float side : {-1.0F, 1.0F}) {
    const Scene corner = scene_of({quad({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, 0),
                                   side > 0 ? quad({-2, 0, -2}, {4, 0, 0}, {0, 3, 0}, 0)
                                            : quad({2, 0, 2}, {-4, 0, 0}, {0, 3, 0}, 0),
                                   quad({-2, 0, 2}, {0, 0, -4}, {0, 3, 0}, 0)});
    EXPECT_GT(side * standpoint_in(corner).position.z, 2.0F);
    EXPECT_GT(standpoint_in(corner).position.x, 2.0F);
  }
}

/// A floor of 100 m does not make what stands on it small.
TEST(Standpoint, ComesNearToWhatStandsOnAFloor) {
  const Mesh floor = quad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, 0);
  const Scene scene =
      scene_of({floor, outward_box({0, 0.5F, 0}, 0.5F), outward_box({2, 1, 0}, 1.0F)});
  const Standpoint stand = standpoint_in(scene);
  EXPECT_THAT(stand.reason, HasSubstr("everything on the floor"));
  EXPECT_LT(glm::length(stand.position), 12.0F);
  EXPECT_GT(stand.position.y, 1.0F);
}

/// Hills of 1 m on 100 m: the whole of them, from above.
TEST(Standpoint, SeesATerrainFromAbove) {
  Mesh terrain = tessellated_quad({-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, 40, 0);
  for (Vec3& position : terrain.positions) {
    position.y = std::sin(0.3F * position.x) * std::cos(0.2F * position.z);
  }
  expect_from_outside(scene_of({terrain}));
  EXPECT_GT(standpoint_in(scene_of({terrain})).position.y, 10.0F);
}

TEST(Standpoint, IsBesideAFlatScene) {
  const Standpoint wall = standpoint_in(scene_of({quad({0, 0, 5}, {2, 0, 0}, {0, 2, 0}, 0)}));
  const auto distance = static_cast<float>(1.0 / (0.9 * std::tan(radians(18.0))));
  expect_near(wall.position, {1, 1, 5 + distance});
  const Standpoint floor = standpoint_in(scene_of({quad({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, 0)}));
  EXPECT_NEAR(floor.position.y, floor.position.z, 0.5F);
  EXPECT_NEAR(floor.heading.azimuth_rad, 0.0, 1e-6);
  EXPECT_NEAR(floor.heading.elevation_rad, radians(-45.0), 1e-6);
  EXPECT_THAT(floor.reason, HasSubstr("flat"));
}

TEST(Standpoint, IsFiniteInScenesOfAnySize) {
  for (const float size : {1e-30F, 1e-10F, 1e10F, 1e30F, 3e38F}) {
    const Scene box = scene_of({outward_box(Vec3(0.0F), size)});
    EXPECT_TRUE(is_finite(standpoint_in(box).position)) << size;
    const Scene wall = scene_of({quad(Vec3(-size), {size, 0, 0}, {0, size, 0}, 0)});
    EXPECT_TRUE(is_finite(standpoint_in(wall).position)) << size;
  }
}

TEST(Standpoint, OfAnEmptySceneIsItsOrigin) {
  const Standpoint stand = standpoint_in(Scene{});
  EXPECT_EQ(stand.position, Vec3(0.0F));
  EXPECT_THAT(stand.reason, HasSubstr("the middle"));
}

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
  EXPECT_THAT(lacks_of(Scene{}, false), ElementsAre(HasSubstr("export all its objects as meshes"),
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
