// Ctrl-C, Escape and the window's cross while a large scene is loaded.
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/encoded_image.h"
#include "tests/end_to_end/preview/preview_command.h"

namespace foveola::test {
namespace {

using testing::HasSubstr;

constexpr const char* words_of_stop = "stopped while a scene was loaded";

/// The room with a texture of 8192 x 8192 texels, which takes much longer to decode than a signal
/// or a key to arrive.
class StoppedLoading : public PreviewCommand {
 protected:
  void SetUp() override {
    constexpr int side = 8192;
    constexpr std::size_t texels = std::size_t{side} * side;
    folder_.write("large.png", encoded_image({.format = "png",
                                              .width = side,
                                              .height = side,
                                              .channels = 1,
                                              .samples = std::vector<std::uint8_t>(texels, 99)}));
    nlohmann::json room = nlohmann::json::parse(room_gltf());
    room["images"] = {{{"uri", "large.png"}}};
    room["textures"] = {{{"source", 0}}};
    room["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    folder_.write("room.gltf", room.dump());
  }

  /// Images are read by a library that is loaded with the first of them.
  static void wait_until_it_reads_images(const RunningProgram& program) {
    wait_until("it reads an image", [&] {
      std::ifstream maps("/proc/" + std::to_string(program.process()) + "/maps");
      const std::string all{std::istreambuf_iterator<char>(maps), {}};
      return all.find("foveola_openimageio") != std::string::npos;
    });
  }

  void expect_preview_stops(const std::function<void(XUser&, RunningProgram&)>& act) {
    RunningProgram program(command({}));
    XUser user(server_.display());
    wait_until_it_reads_images(program);
    act(user, program);
    EXPECT_EQ(program.wait_for_end(), 130);
    EXPECT_THAT(program.said(), HasSubstr(words_of_stop));
  }
};

TEST_F(StoppedLoading, ARenderWritesNothing) {
  const std::string output = folder_ / "picture.png";
  RunningProgram program({"render", scene_, "-o", output, "--size", "64x32", "--spp", "1"});
  wait_until_it_reads_images(program);
  program.kill(SIGINT);
  EXPECT_EQ(program.wait_for_end(), 130);
  EXPECT_THAT(program.said(), HasSubstr(words_of_stop));
  EXPECT_FALSE(std::filesystem::exists(output));
}

TEST_F(StoppedLoading, APreviewEndsByCtrlCEscapeAndItsCross) {
  expect_preview_stops([](XUser&, RunningProgram& program) { program.kill(SIGINT); });
  expect_preview_stops([&](XUser& user, RunningProgram&) {
    user.focus(title_);
    user.type("Escape");
  });
  expect_preview_stops([&](XUser& user, RunningProgram&) { user.ask_to_close(title_); });
}

}  // namespace
}  // namespace foveola::test
