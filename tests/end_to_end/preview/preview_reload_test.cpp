// The preview of a scene whose files change, as its user sees it.
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/end_to_end/preview/preview_command.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

/// A row of the picture that no message covers.
constexpr int above_messages_px = 20;

// The paper's user has changed an object and wants to see it.
TEST_F(PreviewCommand, ShowsTheSceneThatTakesItsFilesPlace) {
  const auto replace = [&](const std::string& bytes) {
    std::filesystem::rename(folder_.write("new", bytes), scene_);
  };
  const auto brightness_is = [&](XUser& user, bool is_bright) {
    wait_until("the changed scene", [&] {
      return (user.brightness_at(title_, 100, above_messages_px) > 0.2) == is_bright;
    });
  };
  const nlohmann::json json = preview_while(
      [&](XUser& user) {
        brightness_is(user, true);
        replace(replaced(room_gltf(), R"("emissiveStrength":10)", R"("emissiveStrength":0.001)"));
        brightness_is(user, false);
        replace("no scene at all");
        replace(room_gltf());
        brightness_is(user, true);
        user.ask_to_close(title_);
      },
      {"--fill-unsampled"});
  ASSERT_GE(json.at("changes").size(), 2U);
  EXPECT_FALSE(json.at("changes").front().at("is_refused"));
  EXPECT_FALSE(json.at("changes").back().at("is_refused"));
  EXPECT_GT(json.at("changes").front().at("seconds_to_first_frame"), 0.0);
  EXPECT_EQ(json.at("last_view"), "--camera 0,-0.4,0 --head 45,0 --fov 60") << "as before";
}

/// A wall of 20 000 triangles, 2 m in front of the origin, that shines or does not. Its waves make
/// each version's vertices others.
std::string wall_glb(int version, bool shines) {
  constexpr int side = 100;
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> indices;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) {
      const double wave = 0.01 * std::sin(x + version);
      positions.emplace_back(0.1 * (x - side / 2), 0.1 * (y - side / 2), wave - 2.0);
    }
  }
  for (int i = 0; i < side * side; ++i) {
    const auto corner = static_cast<std::uint32_t>(i / side * (side + 1) + i % side);
    const std::uint32_t above = corner + side + 1;
    indices.insert(indices.end(), {corner, corner + 1, above, corner + 1, above + 1, above});
  }
  GlbBuilder glb;
  const float emission = shines ? 1.0F : 0.0F;
  const Json material = {{"emissiveFactor", {emission, emission, emission}},
                         {"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 1}}}}};
  const Json primitive = {{"attributes", {{"POSITION", glb.add_vectors(positions)}}},
                          {"indices", glb.add_accessor(indices, uint32, "SCALAR", 1)},
                          {"material", glb.add("materials", material)}};
  glb.add_root({{"mesh", glb.add_mesh(primitive)}});
  return glb.bytes();
}

/// What a process has in memory.
double resident_mib(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) {
      return std::stod(line.substr(line.find(':') + 1)) / 1024.0;
    }
  }
  throw std::runtime_error("the process has no VmRSS");
}

// A version that was kept would add megabytes each time.
TEST_F(PreviewCommand, FortyEditsLeaveNothingBehind) {
  const std::string wall = folder_.write("wall.glb", wall_glb(0, true));
  const std::string title = "Foveola: " + wall;
  RunningProgram program({"preview", wall, "--size", "512x256", "--window", "200x160", "--camera",
                          "0,0,0", "--head", "0,0", "--exposure", "fixed:0", "--fill-unsampled"});
  XUser user(server_.display());
  user.point_at(title, 100, 80);
  const auto wait_until_it = [&](bool shines) {
    wait_until("the changed scene",
               [&] { return (user.brightness_at(title, 100, 40) > 0.5) == shines; });
  };
  const auto replace = [&](const std::string& bytes) {
    std::filesystem::rename(folder_.write("new", bytes), wall);
  };
  wait_until_it(true);
  bool shines = true;
  double early_mib = 0.0;
  for (int edit = 1; edit <= 40; ++edit) {
    if (edit % 4 == 0) {
      replace(wall_glb(edit, shines).substr(0, 1000));
      program.wait_for("does not load");
      continue;
    }
    shines = !shines;
    replace(wall_glb(edit, shines));
    wait_until_it(shines);
    if (edit == 10) {
      early_mib = resident_mib(program.process());
    }
  }
  EXPECT_LT(resident_mib(program.process()), early_mib + 25.0);
  user.ask_to_close(title);
  EXPECT_EQ(program.wait_for_end(), 0) << program.said();
}

}  // namespace
}  // namespace foveola::test
