// `foveola preview` in its window, on a display without a screen.
#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/running_program.h"
#include "tests/waiting.h"
#include "tests/x_server.h"

namespace foveola::test {

class PreviewCommand : public ::testing::Test {
 protected:
  std::vector<std::string> command(const std::vector<std::string>& options) const {
    return joined({"preview", scene_, "--size", "512x256", "--window", "200x160", "--json"},
                  options);
  }

  ProgramResult preview(const std::vector<std::string>& options) const {
    return run_foveola(command(options));
  }

  /// What the preview says at its end, after a user has done something with its window. act: takes
  /// the user, or the user and the program. display: where the window is; empty: on server_.
  template <typename Act>
  nlohmann::json preview_while(const Act& act, const std::vector<std::string>& options = {},
                               const std::string& display = {}) const {
    RunningProgram program(command(options));
    XUser user(display.empty() ? server_.display() : display);
    user.point_at(title_, 100, 80);
    wait_until("the scene", [&] { return user.brightness_at(title_, 100, 80) > 0.0; });
    if constexpr (std::is_invocable_v<Act, XUser&, RunningProgram&>) {
      act(user, program);
    } else {
      act(user);
    }
    EXPECT_EQ(program.wait_for_end(), 0) << program.said();
    const std::string said = program.said();  // notes, too
    const std::size_t begin = said.find("{\n  \"version\"");
    return nlohmann::json::parse(said.substr(begin, said.rfind("\n}") + 2 - begin));
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
