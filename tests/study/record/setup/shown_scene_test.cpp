#include "study/record/setup/shown_scene.h"

#include <fstream>

#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola::study {
namespace {

/// Numbers that a float holds exactly.
SceneSource hall() {
  SceneSource source;
  source.name = "hall";
  source.metres_per_unit = 0.5;
  source.camera_position = Vec3(1.0F, 2.0F, -3.0F);
  source.heading = {.azimuth_rad = 0.5, .elevation_rad = -0.25};
  source.exposure_stops = 1.5;
  source.sky = SunAndSky{.sun = {.azimuth_rad = 1.0, .elevation_rad = 0.75},
                         .turbidity = 4.0,
                         .ground_albedo = 0.125F};
  source.environment_rotation_rad = 0.125;
  source.environment_strength = 2.0;
  source.light_radius_m = 0.0625F;
  source.lights = {{.center = {0.0F, 4.0F, 0.0F},
                    .size = {1.0F, 2.0F},
                    .normal = {0.0F, -1.0F, 0.0F},
                    .radiance = {8.0F, 4.0F, 2.0F}}};
  source.suns = {{.place = {.azimuth_rad = -1.0, .elevation_rad = 0.5},
                  .irradiance = {3.0F, 2.0F, 1.0F},
                  .angular_radius_rad = 0.25}};
  source.objects = {{.name = "Wall", .position = {0.0F, 1.0F, -1.0F}, .radius_deg = 5.0F}};
  return source;
}

/// Its view is the display's. What was recorded before cameras were described stays the same.
TEST(ShownScene, AStudyIsShownWithoutWhatOnlyAPictureHas) {
  SceneSource picture = hall();
  picture.camera_roll_rad = 0.5;
  picture.camera_vertical_fov_rad = 0.75;
  picture.camera_aspect_ratio = 1.5;
  EXPECT_EQ(shown_as(picture), shown_as(hall()));
}

TEST(ShownScene, SaysAllThatTheSourceSaysBeyondItsFile) {
  EXPECT_EQ(
      shown_as(hall()),
      R"({"camera":{"position":[1.0,2.0,-3.0],"azimuth_rad":0.5,"elevation_rad":-0.25},)"
      R"("exposure_stops":1.5,)"
      R"("objects":[{"name":"Wall","position":[0.0,1.0,-1.0],"radius_deg":5.0}],)"
      R"("added":{"metres_per_unit":0.5,)"
      R"("environment":{"sun":{"azimuth_rad":1.0,"elevation_rad":0.75},"turbidity":4.0,)"
      R"("ground_albedo":0.125},)"
      R"("environment_rotation_rad":0.125,"environment_strength":2.0,"light_radius_m":0.0625,)"
      R"("sun_angular_radius_rad":null,)"
      R"("lights":[{"center":[0.0,4.0,0.0],"size":[1.0,2.0],"normal":[0.0,-1.0,0.0],)"
      R"("radiance":[8.0,4.0,2.0]}],)"
      R"("suns":[{"azimuth_rad":-1.0,"elevation_rad":0.5,"irradiance":[3.0,2.0,1.0],)"
      R"("angular_radius_rad":0.25}]}})");
}

/// Records and references of scenes of which it was never said keep their texts.
TEST(ShownScene, SaysUnitsOfLightsAndTimeOfAnimationsWhereTheSourceDoes) {
  SceneSource source = hall();
  const std::string unsaid = added_to_file(source);
  source.light_units = LightUnits::radiometric;
  EXPECT_EQ(difference(unsaid, added_to_file(source)), "light_units: nothing, now \"radiometric\"");
  source.light_units = LightUnits::photometric;
  EXPECT_EQ(difference(unsaid, added_to_file(source)), "light_units: nothing, now \"photometric\"");
  SceneSource posed = hall();
  posed.time_s = 0.5;
  EXPECT_EQ(difference(unsaid, added_to_file(posed)), "time_s: nothing, now 0.5");
}

// The digest is coreutils' of "sky".
TEST(ShownScene, AnEnvironmentsFileIsItsContent) {
  const test::TemporaryFolder folder;
  folder.write("sky.hdr", "sky");
  SceneSource source;
  source.environment_file = folder / "sky.hdr";
  const auto json = nlohmann::json::parse(added_to_file(source));
  EXPECT_EQ(json["environment"]["file_name"], "sky.hdr");
  EXPECT_EQ(json["environment"]["file_sha256"],
            "05f514fae7ca5710f9e9289a20a5c9b372af781bfc94dd23d9cb8a044122460f");
  source.environment_file = folder / "none.hdr";
  EXPECT_THROW(added_to_file(source), Error);
}

TEST(ShownScene, WithoutAnAdditionEveryThingIsTheFiles) {
  const auto json = nlohmann::json::parse(added_to_file({}));
  EXPECT_TRUE(json["environment"].is_null());
  EXPECT_TRUE(json["light_radius_m"].is_null());
  EXPECT_TRUE(json["lights"].empty());
  SceneSource lit;
  lit.environment_radiance = Rgb(0.25F, 0.5F, 1.0F);
  EXPECT_EQ(nlohmann::json::parse(added_to_file(lit))["environment"]["radiance"],
            (std::vector<double>{0.25, 0.5, 1.0}));
}

// The wall is 1 m to the left of the camera, 1 m below it and 2 m behind it.
TEST(ShownScene, HasItsObjectsDirectionsFromTheCamera) {
  const SeenObject wall = object_in(shown_as(hall()), "Wall").value();
  EXPECT_NEAR(degrees(angle_between(wall.direction, {-1.0F, -1.0F, 2.0F})), 0.0, 1e-4);
  EXPECT_NEAR(glm::length(wall.direction), 1.0F, 1e-6F);
  EXPECT_EQ(wall.radius_deg, 5.0);
}

TEST(ShownScene, WhatItDoesNotSayOfAnObjectIsNotGuessed) {
  EXPECT_FALSE(object_in(shown_as(hall()), "Window"));
  SceneSource without_camera = hall();
  without_camera.camera_position.reset();
  EXPECT_FALSE(object_in(shown_as(without_camera), "Wall"));
  SceneSource within = hall();
  within.objects[0].position = *within.camera_position;
  EXPECT_FALSE(object_in(shown_as(within), "Wall"));
  for (const char* text :
       {"{}", "no JSON", "[1]", R"({"camera":{"position":[0,0,0]},"objects":3})",
        R"({"camera":{"position":[0,0,0]},"objects":[{"name":"Wall","radius_deg":5}]})",
        R"({"camera":{"position":[0,0]},"objects":[{"name":"Wall","position":[1,0,0],)"
        R"("radius_deg":5}]})",
        R"({"camera":{"position":[0,0,0]},"objects":[{"name":7,"position":[1,0,0],)"
        R"("radius_deg":5},{"name":"Wall","position":[1,"0",0],"radius_deg":5}]})"}) {
    EXPECT_FALSE(object_in(text, "Wall")) << text;
  }
}

TEST(ShownScene, ANameMayBeNoUnicode) {
  SceneSource source;
  source.objects = {{.name = "v\xff"}};
  EXPECT_THAT(shown_as(source), HasSubstr("v\xEF\xBF\xBD"));
}

TEST(ShownScene, DifferencesAreNamed) {
  const std::string recorded = shown_as(hall());
  SceneSource as_it_is = hall();
  as_it_is.exposure_stops.reset();
  EXPECT_EQ(difference(recorded, shown_as(as_it_is)), "exposure_stops: 1.5, now 0.0");
  EXPECT_EQ(difference(recorded, recorded), "");
  SceneSource turned = hall();
  turned.heading.azimuth_rad = 0.25;
  EXPECT_EQ(difference(recorded, shown_as(turned)), "camera/azimuth_rad: 0.5, now 0.25");
  SceneSource dark = hall();
  dark.lights.clear();
  EXPECT_THAT(difference(recorded, shown_as(dark)), StartsWith("added/lights/0: {"));
  EXPECT_THAT(difference(recorded, shown_as(dark)), EndsWith("now nothing"));
  EXPECT_EQ(difference("no JSON", "{}"), "no JSON, now {}");
}

}  // namespace
}  // namespace foveola::study
