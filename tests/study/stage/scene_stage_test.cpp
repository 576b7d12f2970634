#include "study/stage/scene_stage.h"

#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola::study {
namespace {

SceneStages stages_of(const SceneSource& source) {
  Protocol protocol;
  protocol.scenes = {{.name = "lamps"}};
  return load_stages(protocol, {source}, Workers(1));
}

std::string printed_warnings(const SceneStages& stages) {
  testing::internal::CaptureStderr();
  print_scene_warnings(stages);
  return testing::internal::GetCapturedStderr();
}

TEST(SceneWarnings, OfAStudySayHowTheLightsOfAFileByBlenderAreUnderstood) {
  SceneSource source{.file = TEST_DATA_DIR "/blender/standard.gltf",
                     .camera_position = Vec3(0.0F, 1.0F, 3.0F),
                     .objects = {{.name = "lamp", .position = Vec3(0.0F)}}};
  EXPECT_THAT(printed_warnings(stages_of(source)),
              StartsWith("foveola: warning: lamps: the lights are divided by 683 lm/W"));
  source.light_units = LightUnits::photometric;
  EXPECT_EQ(printed_warnings(stages_of(source)), "");
}

/// Others than participants may look at a scene without it.
TEST(SceneStage, RefusesASceneThatLacksATexture) {
  const test::TemporaryFolder folder;
  folder.write("m.mtl", "newmtl m\nmap_Kd gone.png\n");
  const SceneSource source{
      .file = folder.write("a.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n"),
      .camera_position = Vec3(0.0F, 1.0F, 3.0F),
      .objects = {{.name = "triangle", .position = Vec3(0.0F)}}};
  EXPECT_THROW(stages_of(source), Error);
}

}  // namespace
}  // namespace foveola::study
