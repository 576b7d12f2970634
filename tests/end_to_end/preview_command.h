// `foveola preview` in its window, on a display without a screen.
#pragma once

#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"
#include "tests/waiting.h"
#include "tests/x_server.h"

namespace foveola::test {

class PreviewCommand : public ::testing::Test {
 protected:
  ProgramResult preview(std::vector<std::string> options) const {
    std::vector<std::string> arguments = {"preview",  scene_,    "--size", "512x256",
                                          "--window", "200x160", "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_foveola(arguments);
  }

  /// What the preview says at its end, after a user has done something with its window.
  template <typename Act>
  nlohmann::json preview_while(const Act& act, std::vector<std::string> options = {}) const {
    const std::jthread user_thread([&] {
      XUser user(server_.display());
      user.point_at(title_, 100, 80);
      act(user);
    });
    const ProgramResult result = preview(std::move(options));
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(result.output);
  }

  /// Waits until the check of the gaze shows its target there, black with a white middle, or until
  /// it does not any more.
  void wait_for_target(XUser& user, int x, int y, bool is_there = true) const {
    constexpr int to_the_black_px = 7;
    wait_until(is_there ? "the target" : "the target to go", [&] {
      return (user.brightness_at(title_, x, y) > 0.9 &&
              user.brightness_at(title_, x + to_the_black_px, y) < 0.1) == is_there;
    });
  }

  XServer server_;
  TemporaryFolder folder_;
  std::string scene_ = folder_.write("room.gltf", room_gltf()).string();
  std::string title_ = "Foveola: " + scene_;
};

}  // namespace foveola::test
