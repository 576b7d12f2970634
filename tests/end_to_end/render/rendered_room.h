// The render command on a small room, as a user types it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/files/files.h"
#include "renderer/image/image_file.h"
#include "tests/end_to_end/program.h"

namespace foveola::test {

class Render : public testing::Test {
 protected:
  void SetUp() override { write_file(folder_ / "room.gltf", room_gltf()); }

  ProgramResult render(const std::string& output, const std::vector<std::string>& options) {
    return run_foveola(joined(
        {"render", (folder_ / "room.gltf").string(), "-o", (folder_ / output).string()}, options));
  }

  TemporaryFolder folder_;
};

/// The fraction of an image's pixels that are black.
inline double black_share(const RgbImage& image) {
  const auto black = std::count(image.pixels.begin(), image.pixels.end(), Rgb(0.0F));
  return static_cast<double>(black) / static_cast<double>(image.pixels.size());
}

}  // namespace foveola::test
