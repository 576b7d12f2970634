// What an application learns of the head, the eyes and the hands.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/openxr/application.h"
#include "tests/openxr/runtime/poses.h"
#include "tests/openxr/scripted_headset.h"
#include "tests/x_server.h"

namespace foveola::test {
namespace {

using openxr::degrees_between;
using openxr::pose_of;
using openxr::turned;

constexpr XrSpaceLocationFlags valid_bits =
    XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_POSITION_VALID_BIT;
constexpr XrSpaceLocationFlags tracked_bits =
    XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT | XR_SPACE_LOCATION_POSITION_TRACKED_BIT;

/// A focused application with such a wearer, ten frames a second without waiting for them.
class OpenXrWearerTest : public ::testing::Test {
 protected:
  void wear(const std::string& script) {
    headset_.emplace(R"({"real_time": false, "refresh_hz": 10, )" + script + "}");
    application_.emplace();
    gl_.emplace();
    application_->start(*gl_);
    application_->get_focused();
  }

  void TearDown() override {
    EXPECT_THAT(headset_->log("error"), ::testing::IsEmpty());
    EXPECT_EQ(headset_->found_invalid(), "");
    application_->destroy_session();
  }

  Application& application() { return *application_; }
  const ScriptedHeadset& headset() { return *headset_; }

 private:
  XServer server_;
  std::optional<ScriptedHeadset> headset_;
  std::optional<GlxContext> gl_;
  std::optional<Application> application_;
};

TEST_F(OpenXrWearerTest, HeadFollowsTheScript) {
  wear(R"("head": [{"time": 0, "yaw_deg": 10}, {"time": 0.2, "yaw_deg": 30, "roll_deg": 20,
                                              "position_m": [0.2, 0, -0.4]}])");
  const SeenFrame first = application().frame();
  EXPECT_LT(degrees_between(pose_of(first.head.pose), turned({10.0, 0.0, 0.0})), 0.001);
  const SeenFrame second = application().frame();
  EXPECT_LT(degrees_between(pose_of(second.head.pose), turned({20.0, 0.0, 10.0})), 0.001);
  EXPECT_NEAR(second.head.pose.position.x, 0.1, 1e-6);
  EXPECT_NEAR(second.head.pose.position.z, -0.2, 1e-6);
  EXPECT_EQ(second.head.locationFlags, valid_bits | tracked_bits);
  EXPECT_NEAR(second.stage.pose.position.y, -1.6, 1e-6);
  application().frame();
  const SeenFrame last = application().frame();
  EXPECT_LT(degrees_between(pose_of(last.head.pose), turned({30.0, 0.0, 20.0})), 0.001);
}

TEST_F(OpenXrWearerTest, HeadIsNotTracked) {
  wear(R"("head_gaps": [{"from": 0, "to": 0.1}])");
  const SeenFrame lost = application().frame();
  EXPECT_EQ(lost.head.locationFlags, valid_bits);
  EXPECT_EQ(lost.view_flags,
            XR_VIEW_STATE_ORIENTATION_VALID_BIT | XR_VIEW_STATE_POSITION_VALID_BIT);
  EXPECT_EQ(application().frame().head.locationFlags, valid_bits | tracked_bits);
}

TEST_F(OpenXrWearerTest, GazeFollowsTheScript) {
  wear(R"("head": [{"time": 0, "yaw_deg": 50}],
          "gaze": [{"time": 0, "yaw_deg": 5, "pitch_deg": -3}, {"time": 0.1, "yaw_deg": 15}])");
  const SeenFrame first = application().frame();
  EXPECT_TRUE(first.is_gaze_active);
  EXPECT_EQ(first.gaze_in_view.locationFlags, valid_bits | tracked_bits);
  EXPECT_LT(degrees_between(pose_of(first.gaze_in_view.pose), turned({5.0, -3.0, 0.0})), 0.001);
  const SeenFrame second = application().frame();
  EXPECT_LT(degrees_between(pose_of(second.gaze_in_view.pose), turned({15.0, 0.0, 0.0})), 0.001);
}

TEST_F(OpenXrWearerTest, EyesBlinkAndAreLost) {
  wear(R"("gaze": [{"time": 0, "yaw_deg": 0}, {"time": 0.5, "yaw_deg": 50}],
          "gaze_gaps": [{"from": 0.1, "to": 0.3, "kind": "blink"},
                        {"from": 0.3, "to": 0.4, "kind": "invalid"},
                        {"from": 0.4, "to": 0.5, "kind": "lost"}])");
  EXPECT_EQ(application().frame().gaze_in_view.locationFlags, valid_bits | tracked_bits);
  application().frame();
  const SeenFrame blink = application().frame();
  EXPECT_EQ(blink.gaze_in_view.locationFlags, valid_bits);
  EXPECT_TRUE(blink.is_gaze_active);
  EXPECT_LT(degrees_between(pose_of(blink.gaze_in_view.pose), turned({10.0, 0.0, 0.0})), 0.001);
  const SeenFrame invalid = application().frame();
  EXPECT_EQ(invalid.gaze_in_view.locationFlags, 0U);
  EXPECT_TRUE(invalid.is_gaze_active);
  const SeenFrame lost = application().frame();
  EXPECT_EQ(lost.gaze_in_view.locationFlags, 0U);
  EXPECT_FALSE(lost.is_gaze_active);
  EXPECT_TRUE(application().frame().is_gaze_active);
}

TEST_F(OpenXrWearerTest, SampleTimesAreTrueOrNot) {
  wear(R"("gaze": [{"time": 0}, {"time": 0.1, "yaw_deg": 10}],
          "gaze_sample_time": [{"policy": "true", "delay_ms": 20},
                               {"time": 0.2, "policy": "zero"},
                               {"time": 0.3, "policy": "future"},
                               {"time": 0.4, "policy": "stuck"}])");
  application().frame();
  const SeenFrame truthful = application().frame();
  EXPECT_LE(truthful.gaze_sample_time, truthful.returned_at - 20'000'000);
  EXPECT_GT(truthful.gaze_sample_time, truthful.returned_at - 10'000'000'000);
  EXPECT_LT(degrees_between(pose_of(truthful.gaze_in_view.pose), turned({8.0, 0.0, 0.0})), 0.001);
  EXPECT_EQ(application().frame().gaze_sample_time, 0);
  const SeenFrame future = application().frame();
  EXPECT_GE(future.gaze_sample_time, future.returned_at + 1'000'000'000);
  const SeenFrame stuck = application().frame();
  EXPECT_EQ(application().frame().gaze_sample_time, stuck.gaze_sample_time);
  EXPECT_LT(stuck.gaze_sample_time, truthful.returned_at);
}

TEST_F(OpenXrWearerTest, ButtonsArePressedAndReleased) {
  wear(R"("inputs": [
      {"time": 0.1, "path": "/user/hand/right/input/select/click", "pressed": true},
      {"time": 0.2, "path": "/user/hand/right/input/select/click", "pressed": false},
      {"time": 0.3, "path": "/user/gamepad/input/a/click", "pressed": true}])");
  const SeenFrame before = application().frame();
  EXPECT_EQ(before.select.isActive, XR_TRUE);
  EXPECT_EQ(before.select.currentState, XR_FALSE);
  const SeenFrame pressed = application().frame();
  EXPECT_EQ(pressed.select.currentState, XR_TRUE);
  EXPECT_EQ(pressed.select.changedSinceLastSync, XR_TRUE);
  EXPECT_LE(pressed.select.lastChangeTime, pressed.returned_at);
  EXPECT_GT(pressed.select.lastChangeTime, 0);
  const SeenFrame released = application().frame();
  EXPECT_EQ(released.select.currentState, XR_FALSE);
  EXPECT_EQ(released.select.changedSinceLastSync, XR_TRUE);
  EXPECT_EQ(application().frame().select.currentState, XR_TRUE);
  EXPECT_EQ(application().frame().select.changedSinceLastSync, XR_FALSE);
}

TEST_F(OpenXrWearerTest, TouchControllersTakeThePlaceOfSimpleOnes) {
  wear(R"("interaction_profiles": ["/interaction_profiles/oculus/touch_controller"],
          "inputs": [{"time": 0, "path": "/user/hand/right/input/trigger/value", "value": 0.7}])");
  EXPECT_EQ(application().frame().select.currentState, XR_TRUE);
  XrPath hand = XR_NULL_PATH;
  ASSERT_EQ(xrStringToPath(application().instance(), "/user/hand/right", &hand), XR_SUCCESS);
  XrInteractionProfileState profile{XR_TYPE_INTERACTION_PROFILE_STATE};
  ASSERT_EQ(xrGetCurrentInteractionProfile(application().session(), hand, &profile), XR_SUCCESS);
  std::array<char, XR_MAX_PATH_LENGTH> text{};
  std::uint32_t length = 0;
  ASSERT_EQ(xrPathToString(application().instance(), profile.interactionProfile, text.size(),
                           &length, text.data()),
            XR_SUCCESS);
  EXPECT_STREQ(text.data(), "/interaction_profiles/oculus/touch_controller");
}

TEST_F(OpenXrWearerTest, LocalSpaceIsRecentered) {
  wear(R"("events": [{"time": 0.1, "event": "recentre", "yaw_deg": 90, "position_m": [1, 0, 0],
                      "after_s": 0.05}])");
  application().frame();
  application().poll();
  const SeenFrame announced = application().frame();
  EXPECT_NEAR(announced.head.pose.position.z, 0.0, 1e-6);
  XrEventDataReferenceSpaceChangePending pending{};
  for (const XrEventDataBuffer& event : application().poll()) {
    if (event.type == XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING) {
      pending = reinterpret_cast<const XrEventDataReferenceSpaceChangePending&>(event);
    }
  }
  EXPECT_EQ(pending.referenceSpaceType, XR_REFERENCE_SPACE_TYPE_LOCAL);
  EXPECT_EQ(pending.changeTime, announced.state.predictedDisplayTime + 50'000'000);
  EXPECT_NEAR(pending.poseInPreviousSpace.position.x, 1.0, 1e-6);
  SeenFrame after = application().frame();
  while (after.state.predictedDisplayTime < pending.changeTime) {
    after = application().frame();
  }
  // Left of where LOCAL now looks from, which is to the old left, is the old back.
  EXPECT_NEAR(after.head.pose.position.z, -1.0, 1e-6);
  EXPECT_LT(degrees_between(pose_of(after.head.pose), turned({-90.0, 0.0, 0.0})), 0.001);
}

TEST_F(OpenXrWearerTest, EyesMayLookAskewAndSeeOddly) {
  wear(R"("head": [{"time": 0, "roll_deg": 90}], "eyes": [
      {"fov_deg": {"left": -60, "right": 30, "up": 20, "down": -50}, "offset_m": [-0.03, 0, 0.01],
       "cant_deg": 12}, {"cant_deg": -12}])");
  const SeenFrame seen = application().frame();
  EXPECT_NEAR(seen.views[0].fov.angleLeft, -60.0 * M_PI / 180.0, 1e-6);
  EXPECT_NEAR(seen.views[0].fov.angleDown, -50.0 * M_PI / 180.0, 1e-6);
  // The head lies on its left side, so that the left eye is the lower one.
  EXPECT_NEAR(seen.views[0].pose.position.y, -0.03, 1e-6);
  EXPECT_LT(degrees_between(pose_of(seen.views[0].pose),
                            turned({0.0, 0.0, 90.0}) * turned({12.0, 0.0, 0.0})),
            0.001);
  EXPECT_LT(degrees_between(pose_of(seen.views[1].pose),
                            turned({0.0, 0.0, 90.0}) * turned({-12.0, 0.0, 0.0})),
            0.001);
  EXPECT_EQ(seen.end_result, XR_SUCCESS);
}

TEST_F(OpenXrWearerTest, MaskHidesTriangles) {
  wear(
      R"("eyes": [{"mask": {"vertices": [[-1, -1], [0, -1], [-1, 0]], "indices": [0, 1, 2]}}, {}])");
  const auto get = application().function<PFN_xrGetVisibilityMaskKHR>("xrGetVisibilityMaskKHR");
  const auto mask_of = [&](std::uint32_t view, XrVisibilityMaskKHR& mask) {
    return get(application().session(), XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, view,
               XR_VISIBILITY_MASK_TYPE_HIDDEN_TRIANGLE_MESH_KHR, &mask);
  };
  XrVisibilityMaskKHR mask{XR_TYPE_VISIBILITY_MASK_KHR};
  ASSERT_EQ(mask_of(1, mask), XR_SUCCESS);
  EXPECT_EQ(mask.vertexCountOutput, 0U);
  ASSERT_EQ(mask_of(0, mask), XR_SUCCESS);
  ASSERT_EQ(mask.vertexCountOutput, 3U);
  std::array<XrVector2f, 3> vertices{};
  std::array<std::uint32_t, 3> indices{};
  mask.vertexCapacityInput = mask.indexCapacityInput = 3;
  mask.vertices = vertices.data();
  mask.indices = indices.data();
  ASSERT_EQ(mask_of(0, mask), XR_SUCCESS);
  EXPECT_EQ(vertices[2].x, -1.0F);
  EXPECT_THAT(indices, ::testing::ElementsAre(0U, 1U, 2U));
}

TEST_F(OpenXrWearerTest, TimesAreConvertedThereAndBack) {
  wear(R"("head": [])");
  const SeenFrame seen = application().frame();
  timespec time{};
  ASSERT_EQ(
      application().function<PFN_xrConvertTimeToTimespecTimeKHR>("xrConvertTimeToTimespecTimeKHR")(
          application().instance(), seen.returned_at, &time),
      XR_SUCCESS);
  XrTime back = 0;
  ASSERT_EQ(application().function<PFN_xrConvertTimespecTimeToTimeKHR>(
                "xrConvertTimespecTimeToTimeKHR")(application().instance(), &time, &back),
            XR_SUCCESS);
  EXPECT_EQ(back, seen.returned_at);
  // The runtime's times are not the system's, so that nobody confuses them unnoticed.
  EXPECT_NE(time.tv_sec, seen.returned_at / 1'000'000'000);
}

}  // namespace
}  // namespace foveola::test
