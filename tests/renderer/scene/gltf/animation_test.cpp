#include <cmath>
#include <string>
#include <vector>

#include "renderer/base/error.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

/// one_triangle, whose node 0 an animation moves.
struct Animated {
  GlbBuilder glb = one_triangle();

  /// An animation of one channel; values: of all keys.
  void add(const char* path, const std::vector<float>& times, const std::vector<float>& values,
           std::size_t components, const char* interpolation = "LINEAR") {
    constexpr std::array types = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
    const Json sampler = {
        {"input", glb.add_accessor(times, float32, "SCALAR", 1)},
        {"output", glb.add_accessor(values, float32, types[components], components)},
        {"interpolation", interpolation}};
    const Json channel = {{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}};
    glb.add("animations", {{"samplers", {sampler}}, {"channels", {channel}}});
  }
};

class GltfAnimation : public LoadGltf {
 protected:
  Scene at(const Animated& animated, double time_s) const {
    return load_gltf(write("scene.glb", animated.glb.bytes()), {.time_s = time_s});
  }
  /// Where the triangle's first corner, which is at its node's origin, stands.
  Vec3 origin_at(const Animated& animated, double time_s) const {
    return at(animated, time_s).meshes.at(0).positions.at(0);
  }
  Vec3 second_at(const Animated& animated, double time_s) const {
    return at(animated, time_s).meshes.at(0).positions.at(1);
  }
};

TEST_F(GltfAnimation, WithoutATimeNothingMoves) {
  Animated animated;
  animated.add("translation", {0, 1}, {5, 0, 0, 6, 0, 0}, 3);
  const Scene scene = load(animated.glb);
  EXPECT_EQ(scene.meshes.at(0).positions.at(0), Vec3(0, 0, 0));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("animations are ignored")));
}

TEST_F(GltfAnimation, GoesInLinesAndStaysAtItsEnds) {
  Animated animated;
  animated.add("translation", {1, 2, 4}, {0, 0, 0, 1, 0, 0, 1, 4, 0}, 3);
  EXPECT_EQ(origin_at(animated, 0.0), Vec3(0, 0, 0));
  EXPECT_EQ(origin_at(animated, 1.25), Vec3(0.25F, 0, 0));
  EXPECT_EQ(origin_at(animated, 2.0), Vec3(1, 0, 0));
  EXPECT_EQ(origin_at(animated, 3.5), Vec3(1, 3, 0));
  EXPECT_EQ(origin_at(animated, 99.0), Vec3(1, 4, 0));
  EXPECT_THAT(at(animated, 1.0).warnings, IsEmpty());
}

TEST_F(GltfAnimation, GoesInSteps) {
  Animated animated;
  animated.add("scale", {0, 1}, {1, 1, 1, 3, 1, 1}, 3, "STEP");
  EXPECT_EQ(second_at(animated, 0.99), Vec3(1, 0, 0));
  EXPECT_EQ(second_at(animated, 1.0), Vec3(3, 0, 0));
}

/// A quarter turn about +Z at an even speed: an eighth at half of the time.
TEST_F(GltfAnimation, TurnsOnTheShortestWay) {
  const float h = std::sqrt(0.5F);
  Animated animated;
  animated.add("rotation", {0, 1}, {0, 0, 0, -1, 0, 0, h, h}, 4);
  const Vec3 corner = second_at(animated, 0.5);
  EXPECT_NEAR(corner.x, h, 1e-6F);
  EXPECT_NEAR(corner.y, h, 1e-6F);
}

/// Appendix C.5 with values 0 and 1, out-tangent 4 and in-tangent -2 per second over 2 seconds, at
/// half of the time: 1/2 * 1 + 2 * (1/8 * 4) + 2 * (-1/8 * -2) = 2.
TEST_F(GltfAnimation, GoesOnCubicSplines) {
  Animated animated;
  animated.add("translation", {0, 2}, {9, 9, 9, 0, 0, 0, 4, 0, 0, -2, 0, 0, 1, 0, 0, 9, 9, 9}, 3,
               "CUBICSPLINE");
  EXPECT_NEAR(origin_at(animated, 1.0).x, 2.0F, 1e-6F);
  EXPECT_EQ(origin_at(animated, 2.0), Vec3(1, 0, 0));
}

TEST_F(GltfAnimation, OfTwoTheLaterHolds) {
  Animated animated;
  animated.add("translation", {0}, {1, 0, 0}, 3);
  animated.add("translation", {0}, {2, 0, 0}, 3);
  EXPECT_EQ(origin_at(animated, 0.0), Vec3(2, 0, 0));
  auto& first = animated.glb.document["animations"][0];
  first["channels"].push_back(first["channels"][0]);
  EXPECT_THAT(at(animated, 0.0).warnings,
              ElementsAre("a clip moves one property of a node twice, and the last channel wins "
                          "(animations[0].channels[1])",
                          HasSubstr("the clips 'clip 1', 'clip 2' move the same nodes")));
}

TEST_F(GltfAnimation, MovesMorphTargets) {
  Animated animated;
  const int target = animated.glb.add_vectors({{0, 0, 0}, {0, 0, 8}, {0, 0, 0}});
  animated.glb.primitive()["targets"] = {{{"POSITION", target}}};
  animated.add("weights", {0, 1}, {0, 1}, 1);
  EXPECT_EQ(second_at(animated, 0.25), Vec3(1, 0, 2));
}

TEST_F(GltfAnimation, WarnsOfWhatItCannotMove) {
  Animated animated;
  animated.add("pointer", {0}, {1, 0, 0}, 3);
  animated.add("translation", {0}, {1, 0, 0}, 3);
  animated.glb.document["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  EXPECT_THAT(at(animated, 0.0).warnings,
              ElementsAre(HasSubstr("animations of \"pointer\" are ignored"),
                          HasSubstr("animations of nodes that have a matrix are ignored")));
}

TEST_F(GltfAnimation, RefusesWhatIsNotWhole) {
  const auto error = [&](const Animated& animated) {
    return error_of_bytes(animated.glb.bytes(), "scene.glb", {.time_s = 0.0});
  };
  Animated few;
  few.add("translation", {0, 1}, {1, 0, 0}, 3);
  EXPECT_THAT(error(few), HasSubstr("animations[0].samplers[0]: has 2 times, but 3 numbers of 3"));
  Animated other;
  other.add("rotation", {0}, {1, 0, 0}, 3);
  EXPECT_THAT(error(other), HasSubstr("samplers[0].output: accessors[2] holds 3 x float, but 4"));
  Animated none;
  none.add("scale", {0}, {1, 1, 1}, 3);
  none.glb.document["animations"][0]["channels"][0]["sampler"] = 1;
  EXPECT_THAT(error(none), HasSubstr("channels[0].sampler: is 1, but samplers has 1 elements"));
  none.glb.document["animations"][0]["samplers"][0]["interpolation"] = "SMOOTH";
  EXPECT_THAT(error(none), HasSubstr("interpolation: must be one of LINEAR"));
}

/// tests/data/gltf/two_clips.gltf: at 1 s, Idle has its square one metre up, and Run, which comes
/// after it, five to the right.
Vec3 corner_in(const std::string& clip, std::vector<std::string>* warnings = nullptr) {
  const Scene scene =
      load_gltf(TEST_DATA_DIR "/gltf/two_clips.gltf", {.time_s = 1.0, .clip = clip});
  EXPECT_THAT(scene.clips, ElementsAre("Idle", "Run"));
  if (warnings != nullptr) {
    *warnings = scene.warnings;
  }
  return scene.meshes.at(0).positions.at(0) + Vec3(scene.origin);
}

TEST(GltfClips, OneIsChosenOrTheLastHoldsWithAWarning) {
  EXPECT_EQ(corner_in("Idle"), Vec3(-0.5F, 0.5F, 0.0F));
  std::vector<std::string> warnings;
  EXPECT_EQ(corner_in("Run", &warnings), Vec3(4.5F, -0.5F, 0.0F));
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(corner_in("", &warnings), Vec3(4.5F, -0.5F, 0.0F));
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("the clips 'Idle', 'Run' move the same nodes")));
  EXPECT_THAT([] { (void)corner_in("Walk"); },
              ThrowsMessage<UsageError>(
                  HasSubstr("--clip: the file has no clip 'Walk'; it has 'Idle', 'Run'")));
}

TEST(GltfClips, KeysOutOfOrderAreRefused) {
  const std::string file = TEST_DATA_DIR "/gltf/unsorted_keys.gltf";
  EXPECT_THAT([&] { (void)load_gltf(file, {.time_s = 0.5}); },
              ThrowsMessage<Error>(
                  HasSubstr("animations[0].samplers[0]: has times that are not in order")));
  EXPECT_THAT(load_gltf(file).clips, ElementsAre("clip 1"));
}

}  // namespace
}  // namespace foveola::test
