#include "renderer/scene/prepare/made_up_names.h"

#include "tests/matchers.h"

namespace foveola {
namespace {

std::vector<std::string> names_of(const std::vector<std::string>& in_the_file) {
  std::vector<CameraView> cameras;
  for (const std::string& name : in_the_file) {
    cameras.emplace_back().name = name;
  }
  return camera_names(cameras);
}

TEST(CameraNames, AreTheFilesOrNumbers) {
  EXPECT_THAT(names_of({"Left", "", "Right", ""}),
              ElementsAre("Left", "camera 2", "Right", "camera 4"));
  EXPECT_THAT(names_of({}), IsEmpty());
}

TEST(CameraNames, BelongToOneCameraEach) {
  EXPECT_THAT(names_of({"Left", "Left"}), ElementsAre("Left", "camera 2"));
  EXPECT_THAT(names_of({"", "camera 1"}), ElementsAre("another camera 1", "camera 1"));
  EXPECT_THAT(names_of({"", "camera 1", "another camera 1"}),
              ElementsAre("another another camera 1", "camera 1", "another camera 1"));
}

}  // namespace
}  // namespace foveola
