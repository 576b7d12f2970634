#include "scenes/descriptor.h"

#include <algorithm>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "scenes/builtin.h"
#include "scenes/descriptor_search.h"
#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/scenes/environment.h"
#include "tests/unprivileged.h"

namespace foveola::scenes {
namespace {

const char* const good = R"(title = "A hall"
author = "Somebody"
licence = "CC BY 4.0"
file = "hall.glb"
origin = "example.org"
counterpart = "church"
exposure_stops = -1.5
environment_radiance = [1, 2.5, 3.0]

[camera]
position = [1.0, 2.0, 3.0]
azimuth_deg = 90
elevation_deg = -10.0

[[light]]
center = [0.0, 5.0, 0.0]
size = [2.0, 1.0]
normal = [0, -1, 0]
radiance = [10, 9, 8]

[[object]]
name = "Organ"
position = [4.0, 2.0, -3.0]
radius_deg = 6.5
)";

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

Descriptor described_by(const std::string& content) {
  const TemporaryFolder folder;
  return read_descriptor(folder.write("hall.toml", content));
}

std::string error_of(const std::string& content) {
  return test::error_of([&] { described_by(content); });
}

TEST(Descriptor, LeavesTheExposureOpenWhereItSaysNone) {
  EXPECT_FALSE(described_by(with(good, "exposure_stops = -1.5", "")).source.exposure_stops);
}

/// As far as whoever chooses one goes.
TEST(Descriptor, HasExposuresOfUpTo40Stops) {
  const auto text = [](const char* stops) { return with(good, "-1.5", stops); };
  for (const double stops : {-40.0, 40.0}) {
    EXPECT_EQ(described_by(text(fmt::format("{}", stops).c_str())).source.exposure_stops, stops);
  }
  EXPECT_THAT(error_of(text("40.1")), HasSubstr("exposure_stops is out of range"));
  EXPECT_THAT(error_of(text("-41")), HasSubstr("exposure_stops is out of range"));
}

TEST(Descriptor, ReadsEveryKey) {
  const Descriptor hall = described_by(good);
  EXPECT_EQ(hall.name, "hall");
  EXPECT_EQ(hall.author, "Somebody");
  EXPECT_EQ(hall.licence, "CC BY 4.0");
  EXPECT_EQ(hall.file_name, "hall.glb");
  EXPECT_EQ(hall.origin, "example.org");
  EXPECT_EQ(hall.counterpart, "church");
  EXPECT_FALSE(hall.is_builtin);
  EXPECT_EQ(hall.source.title, "A hall");
  EXPECT_EQ(hall.source.camera_position, Vec3(1.0F, 2.0F, 3.0F));
  EXPECT_NEAR(hall.source.heading.azimuth_rad, 1.5707963267948966, 1e-15);
  EXPECT_NEAR(hall.source.heading.elevation_rad, -0.17453292519943295, 1e-15);
  EXPECT_EQ(hall.source.metres_per_unit, 1.0);
  EXPECT_EQ(hall.source.exposure_stops, -1.5);
  EXPECT_EQ(hall.source.environment_radiance, Rgb(1.0F, 2.5F, 3.0F));
  ASSERT_EQ(hall.source.lights.size(), 1U);
  EXPECT_EQ(hall.source.lights[0].center, Vec3(0.0F, 5.0F, 0.0F));
  EXPECT_EQ(hall.source.lights[0].size, Vec2(2.0F, 1.0F));
  EXPECT_EQ(hall.source.lights[0].normal, Vec3(0.0F, -1.0F, 0.0F));
  EXPECT_EQ(hall.source.lights[0].radiance, Rgb(10.0F, 9.0F, 8.0F));
  ASSERT_EQ(hall.source.objects.size(), 1U);
  EXPECT_EQ(hall.source.objects[0].name, "Organ");
  EXPECT_EQ(hall.source.objects[0].position, Vec3(4.0F, 2.0F, -3.0F));
  EXPECT_EQ(hall.source.objects[0].radius_deg, 6.5F);
}

TEST(Descriptor, MayHaveWhatOnlyAPictureHas) {
  const auto text = [](const char* lines) {
    return with(good, "elevation_deg = -10.0\n", fmt::format("elevation_deg = -10.0\n{}\n", lines));
  };
  const SceneSource source =
      described_by(text("roll_deg = 180\nvertical_fov_deg = 90\naspect_ratio = 0.5")).source;
  EXPECT_NEAR(source.camera_roll_rad, 3.14159265358979, 1e-12);
  EXPECT_NEAR(source.camera_vertical_fov_rad.value(), 1.5707963267948966, 1e-15);
  EXPECT_EQ(source.camera_aspect_ratio, 0.5);
  for (const auto* const refused :
       {"roll_deg = 180.1", "roll_deg = \"left\"", "vertical_fov_deg = 0", "vertical_fov_deg = 180",
        "vertical_fov_deg = nan", "aspect_ratio = 0", "aspect_ratio = -1.5",
        "aspect_ratio = inf"}) {
    EXPECT_THAT(error_of(text(refused)),
                AllOf(HasSubstr("hall.toml:14:"), HasSubstr("out of range")))
        << refused;
  }
  EXPECT_THAT(error_of(text("horizontal_fov_deg = 90")), HasSubstr("unknown key"));
}

/// All places and sizes, so that its numbers are those that a modelling program shows.
TEST(Descriptor, IsInTheFilesUnits) {
  const std::string text = std::string("metres_per_unit = 0.25\n") + good;
  const SceneSource source = described_by(text).source;
  EXPECT_EQ(source.metres_per_unit, 0.25);
  EXPECT_EQ(source.camera_position, Vec3(0.25F, 0.5F, 0.75F));
  EXPECT_EQ(source.lights.at(0).center, Vec3(0.0F, 1.25F, 0.0F));
  EXPECT_EQ(source.lights.at(0).size, Vec2(0.5F, 0.25F));
  EXPECT_EQ(source.lights.at(0).radiance, Rgb(10.0F, 9.0F, 8.0F));
  EXPECT_EQ(source.objects.at(0).position, Vec3(1.0F, 0.5F, -0.75F));
  EXPECT_EQ(source.objects.at(0).radius_deg, 6.5F);
  EXPECT_THAT(error_of(std::string("metres_per_unit = 0\n") + good),
              HasSubstr("metres_per_unit is out of range"));
}

TEST(Descriptor, MayLeaveOutWhoMadeTheScene) {
  const std::string text = with(good, "author = \"Somebody\"\nlicence = \"CC BY 4.0\"\n", "");
  const Descriptor hall = described_by(text);
  EXPECT_EQ(hall.author, "");
  EXPECT_EQ(hall.licence, "");
}

TEST(Descriptor, AnImageOfTheEnvironmentLiesInItsFolder) {
  const TemporaryFolder folder;
  const std::string image = folder.write("lights/studio.hdr", "x").string();
  const auto text = [&](const std::string& name) {
    return with(good, "environment_radiance = [1, 2.5, 3.0]",
                "environment_file = \"" + name + "\"\nenvironment_rotation_deg = 90");
  };
  const SceneSource source =
      read_descriptor(folder.write("hall.toml", text("lights/studio.hdr"))).source;
  EXPECT_EQ(source.environment_file, std::filesystem::canonical(image));
  EXPECT_DOUBLE_EQ(source.environment_rotation_rad, 1.5707963267948966);
  EXPECT_THAT(error_of(text("../studio.hdr")),
              AllOf(HasSubstr("hall.toml:8:20"), HasSubstr("leads out of the folder")));
  EXPECT_THAT(error_of(text("studio.hdr")), HasSubstr("does not exist"));
  EXPECT_THAT(error_of("environment_file = \"a.hdr\"\n" + std::string(good)),
              HasSubstr("the scene has several environments"));
}

TEST(Descriptor, IsToldFromOtherFiles) {
  const TemporaryFolder folder;
  EXPECT_TRUE(is_descriptor(folder.write("a.toml", good)));
  EXPECT_TRUE(is_descriptor(folder.write("a.toml", "builtin = true\n")));
  EXPECT_FALSE(is_descriptor(folder.write("a.toml", "title = \"A study\"\nscenes = [\"a\"]\n")));
  EXPECT_THROW(is_descriptor(folder.write("a.toml", "title = ")), Error);
}

TEST(Descriptor, SaysWhatTheFilesLightsAreGivenIn) {
  const auto units_of = [&](const std::string& line) {
    return described_by(line + good).source.light_units;
  };
  EXPECT_EQ(units_of(""), std::nullopt);
  EXPECT_EQ(units_of("light_units = \"photometric\"\n"), LightUnits::photometric);
  EXPECT_EQ(units_of("light_units = \"radiometric\"\n"), LightUnits::radiometric);
  EXPECT_THAT(error_of(std::string("light_units = \"lumen\"\n") + good),
              AllOf(HasSubstr("hall.toml:1"), HasSubstr("light_units")));
}

TEST(Descriptor, SunsStandBesideTheEnvironment) {
  const std::string sun =
      "\n[[sun]]\nazimuth_deg = 180\nelevation_deg = 45\nirradiance = [5, 4.5, 4]\n";
  const SceneSource source = described_by(good + sun).source;
  EXPECT_TRUE(source.environment_radiance.has_value());
  ASSERT_EQ(source.suns.size(), 1U);
  EXPECT_NEAR(source.suns[0].place.azimuth_rad, 3.14159265358979, 1e-12);
  EXPECT_NEAR(source.suns[0].place.elevation_rad, 0.785398163397448, 1e-12);
  EXPECT_EQ(source.suns[0].irradiance, Rgb(5.0F, 4.5F, 4.0F));
  EXPECT_DOUBLE_EQ(source.suns[0].angular_radius_rad, solar_angular_radius_rad);
  EXPECT_THAT(error_of(good + with(sun, "irradiance = [5, 4.5, 4]", "")), HasSubstr("irradiance"));
  EXPECT_THAT(error_of(good + sun + "angular_radius_deg = 60\n"),
              HasSubstr("angular_radius_deg is out of range"));
}

TEST(Descriptor, DaylightIsAnEnvironmentOfItsOwn) {
  const std::string constant = "environment_radiance = [1, 2.5, 3.0]\n";
  const std::string sky = "\n[sky]\nsun_azimuth_deg = 90\nsun_elevation_deg = 30\nturbidity = 4\n";
  const SceneSource source = described_by(with(good, constant, "") + sky).source;
  ASSERT_TRUE(source.sky.has_value());
  EXPECT_FALSE(source.environment_radiance.has_value());
  EXPECT_NEAR(source.sky->sun.azimuth_rad, 1.5707963267948966, 1e-15);
  EXPECT_NEAR(source.sky->sun.elevation_rad, 0.5235987755982988, 1e-15);
  EXPECT_EQ(source.sky->turbidity, 4.0);
  EXPECT_THAT(error_of(good + sky), HasSubstr("several environments"));
  EXPECT_THAT(error_of(with(good, constant, "") + with(sky, "turbidity = 4", "turbidity = 11")),
              HasSubstr("sky.turbidity is out of range"));
}

TEST(Descriptor, UnknownKeysAreNamedWithLineAndColumn) {
  EXPECT_THAT(error_of(with(good, "origin =", "oirgin =")),
              AllOf(HasSubstr("hall.toml:5:1"), HasSubstr("'oirgin'")));
  EXPECT_THAT(error_of(with(good, "normal =", "  nromal =")), HasSubstr("hall.toml:15:1"));
  EXPECT_THAT(error_of(std::string(good) + "  color = 3\n"),
              AllOf(HasSubstr("hall.toml:25:3"), HasSubstr("'object.color'")));
}

TEST(Descriptor, WrongTypesAndValuesAreNamedWithTheirPlace) {
  EXPECT_THAT(error_of(with(good, "\"A hall\"", "7")),
              AllOf(HasSubstr("hall.toml:1:9"), HasSubstr("title must be a text")));
  EXPECT_THAT(error_of(with(good, "exposure_stops = -1.5", "exposure_stops = \"dark\"")),
              HasSubstr("hall.toml:7:18"));
  EXPECT_THAT(error_of(with(good, "azimuth_deg = 90", "azimuth_deg = 400")),
              HasSubstr("hall.toml:12:15"));
  EXPECT_THAT(error_of(with(good, "azimuth_deg = 90", "azimuth_deg = nan")),
              HasSubstr("hall.toml:12:15"));
  EXPECT_THAT(error_of(with(good, "[1.0, 2.0, 3.0]", "[1.0, 2.0]")),
              AllOf(HasSubstr("hall.toml:11:12"), HasSubstr("3 numbers")));
  EXPECT_THAT(error_of(with(good, "[1.0, 2.0, 3.0]", "[1.0, \"x\", 3.0]")),
              HasSubstr("hall.toml:11:18"));
  EXPECT_THAT(error_of(with(good, "normal = [0, -1, 0]", "normal = [0, -1, 1]")),
              HasSubstr("must be an axis"));
  EXPECT_THAT(error_of(with(good, "[[light]]", "[light]")), HasSubstr("[[light]]"));
  EXPECT_THAT(error_of(with(good, "radiance = [10, 9, 8]", "radiance = [10, -9, 8]")),
              HasSubstr("hall.toml:19:17"));
}

TEST(Descriptor, FilesAreNamesOfScenesWithoutFolders) {
  const auto text = [](const char* name) {
    return with(good, "file = \"hall.glb\"", fmt::format("file = \"{}\"", name));
  };
  for (const char* const name : {"hall.glb", "hall.gltf", "hall.obj", "Hall.GLB"}) {
    EXPECT_EQ(described_by(text(name)).file_name, name);
  }
  for (const char* const name :
       {"../hall.glb", "halls/hall.glb", "/hall.glb", "..", "", "h.blend"}) {
    EXPECT_THAT(error_of(text(name)),
                AllOf(HasSubstr("hall.toml:4:8"), HasSubstr("without folders")))
        << name;
  }
}

TEST(Descriptor, SizesMayExceedAnInt) {
  const std::string text = std::string("size_bytes = 5000000000\n") + good;
  EXPECT_EQ(described_by(text).size_bytes, 5'000'000'000U);
  EXPECT_THAT(error_of(std::string("size_bytes = 0\n") + good),
              HasSubstr("size_bytes is out of range"));
}

TEST(Descriptor, ObjectsHaveNamesAndDirectionsOfTheirOwn) {
  const std::string again =
      "\n[[object]]\nname = \"Organ\"\nposition = [1, 2, 0]\nradius_deg = 4\n";
  EXPECT_THAT(error_of(good + again),
              AllOf(HasSubstr("hall.toml:27:8"), HasSubstr("two objects are named \"Organ\"")));
  EXPECT_THAT(
      error_of(with(good, "position = [4.0, 2.0, -3.0]", "position = [1.0, 2.0, 3.0]")),
      AllOf(HasSubstr("hall.toml:23:12"), HasSubstr("the object's position is the camera's")));
}

TEST(Descriptor, BuiltinScenesThatDoNotExistAreRefused) {
  EXPECT_THAT(error_of(with(good, "counterpart = \"church\"", "counterpart = \"castle\"")),
              AllOf(HasSubstr("hall.toml:6:15"), HasSubstr("no built-in scene is named castle")));
  EXPECT_THAT(error_of(with(good, "file = \"hall.glb\"", "builtin = true")),
              AllOf(HasSubstr("hall.toml:4:11"), HasSubstr("no built-in scene is named hall")));
}

TEST(Descriptor, OneThatCannotBeReadDoesNotHideTheOthers) {
  const TemporaryFolder folder;
  const EnvironmentVariable resources("FOVEOLA_RESOURCES", folder.path().string());
  folder.write("protocols/none.toml", "");
  folder.write("scenes/broken.toml", "title = 7\n");
  folder.write("scenes/hall.toml", good);
  const DescriptorList list = all_descriptors();
  ASSERT_EQ(list.descriptors.size(), 1U);
  EXPECT_EQ(list.descriptors[0].name, "hall");
  EXPECT_THAT(list.faults, testing::Contains(HasSubstr("broken.toml:1:9")));
  EXPECT_TRUE(find_descriptor("hall").has_value());
  EXPECT_THROW(find_descriptor("broken"), Error);
}

TEST(Descriptor, TheDescribedFileIsDistinguishedFromOthers) {
  const TemporaryFolder folder;
  Descriptor hall;
  hall.size_bytes = 3;
  hall.sha256 = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";  // FIPS 180-4
  EXPECT_TRUE(is_described_file(hall, folder.write("right", "abc")));
  EXPECT_FALSE(is_described_file(hall, folder.write("longer", "abcd")));
  EXPECT_FALSE(is_described_file(hall, folder.write("as long", "abd")));
  EXPECT_THROW(is_described_file(hall, folder.path() / "missing"), Error);
}

TEST(Descriptor, MissingKeysAreNamed) {
  EXPECT_THAT(error_of(with(good, "title = \"A hall\"\n", "")), HasSubstr("title is missing"));
  EXPECT_THAT(error_of(with(good, "radius_deg = 6.5\n", "")), HasSubstr("radius_deg is missing"));
}

TEST(Descriptor, IsEitherBuiltInOrHasAFile) {
  EXPECT_THAT(error_of(with(good, "file = \"hall.glb\"", "builtin = true\nfile = \"hall.glb\"")),
              HasSubstr("either built in or have a file"));
  EXPECT_THAT(error_of(with(good, "file = \"hall.glb\"\n", "")),
              HasSubstr("either built in or have a file"));
}

TEST(Descriptor, EveryBuiltinSceneHasOneAndEveryBuiltinOneHasAScene) {
  std::vector<std::string> names;
  const DescriptorList list = all_descriptors();
  EXPECT_THAT(list.faults, testing::IsEmpty());
  for (const Descriptor& descriptor : list.descriptors) {
    if (descriptor.is_builtin) {
      names.push_back(descriptor.name);
    }
  }
  EXPECT_EQ(names, builtin_names());
}

TEST(Descriptor, TheStudysFiveScenesHaveOneWithObjectsInView) {
  for (const char* const name : {"bmw", "classroom", "conference", "sibenik", "sponza"}) {
    SCOPED_TRACE(name);
    const auto descriptor = find_descriptor(name);
    ASSERT_TRUE(descriptor.has_value());
    EXPECT_FALSE(descriptor->is_builtin);
    EXPECT_THAT(descriptor->origin, testing::StartsWith("https://"));
    const SceneSource& source = descriptor->source;
    EXPECT_GE(source.objects.size(), 2U);
    for (const ObjectOfInterest& object : source.objects) {
      const Vec3 towards = object.position - source.camera_position.value();
      EXPECT_LT(degrees(angle_between(towards, direction_from(source.heading))), 45.0)
          << object.name;
    }
  }
}

TEST(Descriptor, NamesThatAreNoNamesHaveNone) {
  for (const char* const name : {"", ".", "..", "../scenes/arcade", "./arcade", "castle"}) {
    EXPECT_FALSE(find_descriptor(name).has_value()) << name;
  }
  EXPECT_FALSE(find_descriptor(std::string(300, 'x')).has_value());
}

TEST(Descriptor, AFolderWithoutThemIsNamed) {
  const TemporaryFolder folder;
  const EnvironmentVariable resources("FOVEOLA_RESOURCES", folder.path().string());
  folder.write("protocols/none.toml", "");
  folder.write("scenes", "a file");
  EXPECT_THAT([] { all_descriptors(); },
              testing::ThrowsMessage<Error>(
                  AllOf(HasSubstr("scenes: cannot be read"), HasSubstr("FOVEOLA_RESOURCES"))));
}

TEST(Descriptor, OneThatMayNotBeReadIsNoUnknownScene) {
  const TemporaryFolder folder;
  test::open_to_all(folder.path());
  const EnvironmentVariable resources("FOVEOLA_RESOURCES", folder.path().string());
  folder.write("protocols/none.toml", "");
  folder.write("scenes/hall.toml", good);
  const test::Locked locked(folder / "scenes");
  const test::Unprivileged unprivileged;
  EXPECT_THAT([] { find_descriptor("hall"); },
              testing::ThrowsMessage<Error>(HasSubstr("hall.toml: cannot be reached")));
}

}  // namespace
}  // namespace foveola::scenes
