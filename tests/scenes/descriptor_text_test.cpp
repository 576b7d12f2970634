#include "scenes/descriptor_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "scenes/descriptor.h"
#include "tests/scenes/environment.h"

namespace foveola::scenes {
namespace {

using testing::HasSubstr;

SceneSource kitchen() {
  SceneSource source;
  source.title = "My \"kitchen\" \\ Küche";
  source.file = "/somewhere/kitchen.glb";
  source.described_sha256 = std::string(64, 'a');
  source.light_units = LightUnits::radiometric;
  source.camera_position = Vec3(1.25F, -2.5F, 1e-3F);
  source.heading = {.azimuth_rad = -3.0, .elevation_rad = 0.25};
  source.exposure_stops = -2.75;
  source.objects = {{.name = "Cup", .position = {0.5F, 1.0F, -2.0F}, .radius_deg = 1.5F},
                    {.name = "Pan", .position = {-0.5F, 1.0F, -2.0F}, .radius_deg = 6.25F}};
  return source;
}

SceneSource written_and_read(const SceneSource& source,
                             const std::vector<std::string>& remarks = {}) {
  const TemporaryFolder folder;
  folder.write("studio.hdr", "x");
  return read_descriptor(folder.write("kitchen.toml", descriptor_text(source, remarks))).source;
}

TEST(DescriptorText, IsReadAsItWasMeant) {
  const SceneSource source = kitchen();
  const SceneSource read = written_and_read(source, {"half of it visible", "all\nof it"});
  EXPECT_EQ(read.title, source.title);
  EXPECT_EQ(read.described_sha256, source.described_sha256);
  EXPECT_EQ(read.light_units, source.light_units);
  EXPECT_EQ(read.camera_position, source.camera_position);
  EXPECT_NEAR(read.heading.azimuth_rad, -3.0, 1e-5);
  EXPECT_NEAR(read.heading.elevation_rad, 0.25, 1e-6);
  EXPECT_EQ(read.exposure_stops, -2.75);
  ASSERT_EQ(read.objects.size(), 2U);
  EXPECT_EQ(read.objects[1].name, "Pan");
  EXPECT_EQ(read.objects[1].position, source.objects[1].position);
  EXPECT_EQ(read.objects[1].radius_deg, 6.25F);
}

TEST(DescriptorText, KeepsTheCameraToTheBit) {
  SceneSource source = kitchen();
  source.camera_position = Vec3(0.1F, -1.0F / 3.0F, 12345.678F);
  source.heading = {.azimuth_rad = radians(-123.456), .elevation_rad = radians(0.1)};
  source.camera_roll_rad = radians(-20.0);
  source.camera_vertical_fov_rad = radians(40.0);
  source.camera_aspect_ratio = 1.5;
  EXPECT_THAT(descriptor_text(source, {}),
              HasSubstr("position = [0.1, -0.33333334, 12345.678]\n"
                        "azimuth_deg = -123.456\nelevation_deg = 0.1\n"
                        "roll_deg = -20\nvertical_fov_deg = 40\naspect_ratio = 1.5\n"));
  const SceneSource read = written_and_read(source);
  EXPECT_EQ(read.camera_position, source.camera_position);
  EXPECT_EQ(read.heading.azimuth_rad, source.heading.azimuth_rad);
  EXPECT_EQ(read.heading.elevation_rad, source.heading.elevation_rad);
  EXPECT_EQ(read.camera_roll_rad, source.camera_roll_rad);
  EXPECT_EQ(read.camera_vertical_fov_rad, source.camera_vertical_fov_rad);
  EXPECT_EQ(read.camera_aspect_ratio, 1.5);
}

TEST(DescriptorText, SaysOfThePictureWhatTheCameraHas) {
  EXPECT_THAT(
      descriptor_text(kitchen(), {}),
      testing::Not(testing::AnyOf(HasSubstr("roll"), HasSubstr("fov"), HasSubstr("aspect"))));
  const SceneSource read = written_and_read(kitchen());
  EXPECT_EQ(read.camera_roll_rad, 0.0);
  EXPECT_FALSE(read.camera_vertical_fov_rad);
  EXPECT_FALSE(read.camera_aspect_ratio);
}

TEST(DescriptorText, IsInTheFilesUnits) {
  SceneSource source = kitchen();
  source.metres_per_unit = 0.01;
  EXPECT_THAT(descriptor_text(source, {}), HasSubstr("position = [125, -250, 0.1]"));
  EXPECT_NEAR(written_and_read(source).camera_position->x, 1.25F, 1e-5F);
}

TEST(DescriptorText, HasNoNegativeZeros) {
  SceneSource source = kitchen();
  source.camera_position = Vec3(-0.0F);
  source.heading = {.azimuth_rad = -0.0, .elevation_rad = -0.0};
  EXPECT_THAT(descriptor_text(source, {}),
              HasSubstr("position = [0, 0, 0]\nazimuth_deg = 0\nelevation_deg = 0\n"));
}

TEST(DescriptorText, HasTheEnvironment) {
  SceneSource source = kitchen();
  source.sky = SunAndSky{.sun = {.azimuth_rad = 1.0, .elevation_rad = 0.5}, .turbidity = 4.0};
  source.environment_strength = 0.25;
  const SceneSource read = written_and_read(source);
  ASSERT_TRUE(read.sky.has_value());
  EXPECT_NEAR(read.sky->sun.azimuth_rad, 1.0, 1e-5);
  EXPECT_EQ(read.sky->turbidity, 4.0);
  EXPECT_EQ(read.environment_strength, 0.25);

  source = kitchen();
  source.environment_radiance = Rgb(1.0F, 2.0F, 3.5F);
  EXPECT_EQ(written_and_read(source).environment_radiance, source.environment_radiance);

  source = kitchen();
  source.environment_file = "/somewhere/studio.hdr";
  source.environment_rotation_rad = 0.5;
  EXPECT_EQ(written_and_read(source).environment_file->filename(), "studio.hdr");
  EXPECT_NEAR(written_and_read(source).environment_rotation_rad, 0.5, 1e-6);
}

TEST(DescriptorText, HasTheSizesOfLights) {
  SceneSource source = kitchen();
  source.metres_per_unit = 0.5;
  source.light_radius_m = 0.25F;
  source.sun_angular_radius_rad = 0.0F;
  EXPECT_THAT(descriptor_text(source, {}), HasSubstr("light_radius = 0.5\nsun_radius_deg = 0\n"));
  EXPECT_EQ(written_and_read(source).light_radius_m, 0.25F);
  EXPECT_EQ(written_and_read(source).sun_angular_radius_rad, 0.0F);
  EXPECT_EQ(written_and_read(kitchen()).light_radius_m, std::nullopt);
}

TEST(DescriptorText, HasAzimuthsWithinHalfATurn) {
  SceneSource source = kitchen();
  source.heading.azimuth_rad = radians(190.0);
  source.sky = SunAndSky{.sun = {.azimuth_rad = radians(-725.0), .elevation_rad = 0.5}};
  EXPECT_THAT(descriptor_text(source, {}), testing::AllOf(HasSubstr("\nazimuth_deg = -170\n"),
                                                          HasSubstr("sun_azimuth_deg = -5\n")));
  source.heading.azimuth_rad = radians(180.0);
  EXPECT_THAT(descriptor_text(source, {}), HasSubstr("\nazimuth_deg = 180\n"));
}

TEST(DescriptorText, TurnsTheEnvironmentByLessThanATurn) {
  SceneSource source = kitchen();
  source.environment_radiance = Rgb(1.0F);
  source.environment_rotation_rad = radians(270.0);
  EXPECT_THAT(descriptor_text(source, {}), HasSubstr("environment_rotation_deg = 270\n"));
  source.environment_rotation_rad = radians(-1000.0);
  EXPECT_THAT(descriptor_text(source, {}), HasSubstr("environment_rotation_deg = -280\n"));
}

TEST(DescriptorText, IsRefusedIfNobodyCouldReadIt) {
  const auto refusal = [](const SceneSource& source, const std::string& says) {
    EXPECT_THAT([&] { descriptor_text(source, {}); },
                testing::ThrowsMessage<Error>(HasSubstr(says)));
  };
  SceneSource source = kitchen();
  source.camera_position->x = 2e6F;
  refusal(source, "kitchen.toml:8:13: camera.position is out of range");
  source = kitchen();
  source.environment_strength = 1e9;
  refusal(source, "environment_strength is out of range");
  source = kitchen();
  source.objects[1].name = "Cup";
  refusal(source, "two objects are named \"Cup\"");
}

TEST(DescriptorText, HoldsTheNamesOfFilesAsTheyAre) {
  for (const char* const name : {"a\nb.glb", "a\x7f.glb", "a\xff.glb"}) {
    SceneSource source = kitchen();
    source.file = name;
    EXPECT_THAT([&] { descriptor_text(source, {}); },
                testing::ThrowsMessage<Error>(HasSubstr("give it a name in UTF-8")));
    source.file = "kitchen.glb";
    source.environment_file = name;
    EXPECT_THROW(descriptor_text(source, {}), Error);
  }
  SceneSource source = kitchen();
  source.file = "K\u00fcche \"\\.GLB";
  const TemporaryFolder folder;
  EXPECT_EQ(read_descriptor(folder.write("k.toml", descriptor_text(source, {}))).file_name,
            source.file);
}

TEST(DescriptorText, KeepsToTomlWhateverTheFileIsCalled) {
  SceneSource source = kitchen();
  source.title = "a\nb\x7f\xff";
  EXPECT_THAT(written_and_read(source).title, testing::StartsWith("a b?"));
}

}  // namespace
}  // namespace foveola::scenes
