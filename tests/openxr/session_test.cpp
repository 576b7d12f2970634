// What a session goes through, as an application sees it through OpenXR's loader.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/openxr/application.h"
#include "tests/openxr/scripted_headset.h"
#include "tests/x_server.h"

namespace foveola::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;

std::vector<std::string> values_of(const std::vector<nlohmann::json>& lines, const char* key) {
  std::vector<std::string> values;
  for (const nlohmann::json& line : lines) {
    values.push_back(line.at(key));
  }
  return values;
}

std::vector<std::string> states_of(const ScriptedHeadset& headset) {
  return values_of(headset.log("state"), "state");
}

std::vector<XrStructureType> types_of(const std::vector<XrEventDataBuffer>& events) {
  std::vector<XrStructureType> types;
  for (const XrEventDataBuffer& event : events) {
    types.push_back(event.type);
  }
  return types;
}

/// On a display of its own.
class OpenXrSessionTest : public ::testing::Test {
 protected:
  XServer server;
};

TEST_F(OpenXrSessionTest, GetsFocusedAndNothingIsInvalid) {
  const ScriptedHeadset headset;
  {
    const GlxContext gl;
    Application application;
    application.start(gl);
    application.get_focused();
    EXPECT_EQ(application.frames(3).end_result, XR_SUCCESS);
    application.destroy_session();
  }
  EXPECT_THAT(states_of(headset),
              ElementsAre("IDLE", "READY", "SYNCHRONIZED", "VISIBLE", "FOCUSED"));
  const nlohmann::json instance = headset.log("instance").at(0);
  EXPECT_EQ(instance["application"], "small application");
  EXPECT_EQ(instance["engine"], "no engine");
  EXPECT_EQ(instance["extensions"].size(), Application::all_extensions().size());
  EXPECT_THAT(headset.log("error"), IsEmpty());
  EXPECT_EQ(headset.log("end").size(), 1U);
  EXPECT_EQ(headset.found_invalid(), "");
}

TEST_F(OpenXrSessionTest, FramesComeAtTheRefreshRate) {
  const ScriptedHeadset headset(R"({"refresh_hz": 50})");
  const GlxContext gl;
  Application application;
  application.start(gl);
  application.get_focused();
  const SeenFrame first = application.frame();
  const SeenFrame later = application.frames(5);
  EXPECT_EQ(first.state.predictedDisplayPeriod, 20'000'000);
  EXPECT_GE(later.state.predictedDisplayTime - first.state.predictedDisplayTime, 100'000'000);
  // A frame is never handed out earlier than a period before it is shown.
  EXPECT_GE(later.returned_at, later.state.predictedDisplayTime - 20'000'000);
}

TEST_F(OpenXrSessionTest, FramesAreNumberedFromTheFirstFocus) {
  const ScriptedHeadset headset(R"({"real_time": false, "refresh_hz": 10})");
  const GlxContext gl;
  Application application;
  application.start(gl);
  application.get_focused();
  application.frames(2);
  std::vector<std::pair<int, double>> frames;
  for (const nlohmann::json& line : headset.log("frame")) {
    frames.emplace_back(line["frame"], line["time_s"]);
  }
  EXPECT_THAT(frames, ElementsAre(std::pair(-1, -1.0), std::pair(-1, -1.0), std::pair(-1, -1.0),
                                  std::pair(0, 0.0), std::pair(1, 0.1)));
}

TEST_F(OpenXrSessionTest, LosesFocusIsHiddenAndComesBack) {
  const ScriptedHeadset headset(R"({"real_time": false, "refresh_hz": 10, "events": [
      {"time": 0.1, "event": "focus_lost"}, {"time": 0.2, "event": "focus_gained"},
      {"time": 0.3, "event": "hidden"}, {"time": 0.4, "event": "shown"}]})");
  const GlxContext gl;
  Application application;
  application.start(gl);
  application.get_focused();
  EXPECT_EQ(application.frame().sync_result, XR_SUCCESS);
  const SeenFrame unfocused = application.frame();
  EXPECT_EQ(unfocused.sync_result, XR_SESSION_NOT_FOCUSED);
  EXPECT_EQ(unfocused.state.shouldRender, XR_TRUE);
  EXPECT_FALSE(unfocused.is_gaze_active);
  EXPECT_EQ(application.frame().sync_result, XR_SUCCESS);
  EXPECT_EQ(application.frame().state.shouldRender, XR_FALSE);
  EXPECT_EQ(application.frame().state.shouldRender, XR_TRUE);
  application.poll();
  EXPECT_EQ(application.state(), XR_SESSION_STATE_FOCUSED);
  EXPECT_EQ(states_of(headset).size(), 5U + 2U + 4U);
  EXPECT_EQ(headset.found_invalid(), "");
}

TEST_F(OpenXrSessionTest, IsTakenOffAndPutOn) {
  const ScriptedHeadset headset(R"({"real_time": false, "refresh_hz": 10, "events": [
      {"time": 0.0, "event": "taken_off"}, {"time": 0.1, "event": "put_on"}]})");
  const GlxContext gl;
  Application application;
  application.start(gl);
  application.get_focused();
  application.frame();
  std::vector<XrStructureType> off = types_of(application.poll());
  EXPECT_EQ(application.state(), XR_SESSION_STATE_VISIBLE);
  application.frame();
  application.poll();
  EXPECT_EQ(application.state(), XR_SESSION_STATE_FOCUSED);
#ifdef XR_EXT_user_presence
  EXPECT_EQ(off.front(), XR_TYPE_EVENT_DATA_USER_PRESENCE_CHANGED_EXT);
#endif
}

TEST_F(OpenXrSessionTest, ExitsAsTheRuntimeWants) {
  const ScriptedHeadset headset(
      R"({"real_time": false, "events": [{"time": 0, "event": "exit"}]})");
  const GlxContext gl;
  Application application;
  application.start(gl);
  application.get_focused();
  application.frame();
  application.poll();
  application.poll();
  EXPECT_EQ(application.state(), XR_SESSION_STATE_EXITING);
  EXPECT_THAT(states_of(headset),
              ElementsAre("IDLE", "READY", "SYNCHRONIZED", "VISIBLE", "FOCUSED", "VISIBLE",
                          "SYNCHRONIZED", "STOPPING", "IDLE", "EXITING"));
  EXPECT_EQ(headset.found_invalid(), "");
}

TEST_F(OpenXrSessionTest, ExitsAsTheApplicationWants) {
  const ScriptedHeadset headset(R"({"real_time": false})");
  const GlxContext gl;
  Application application;
  application.start(gl);
  application.get_focused();
  EXPECT_EQ(xrEndSession(application.session()), XR_ERROR_SESSION_NOT_STOPPING);
  EXPECT_EQ(xrRequestExitSession(application.session()), XR_SUCCESS);
  application.poll();
  EXPECT_EQ(application.state(), XR_SESSION_STATE_EXITING);
}

TEST_F(OpenXrSessionTest, StartsAgain) {
  const ScriptedHeadset headset(
      R"({"real_time": false, "events": [{"time": 0, "event": "restart"}]})");
  const GlxContext gl;
  Application application;
  application.start(gl);
  application.get_focused();
  application.frame();
  application.poll();
  application.get_focused();
  application.frame();
  EXPECT_EQ(headset.log("frame").back()["frame"], 4);
  EXPECT_THAT(headset.log("error"), IsEmpty());
}

TEST_F(OpenXrSessionTest, IsLost) {
  const ScriptedHeadset headset(
      R"({"real_time": false, "events": [{"time": 0, "event": "session_loss"}]})");
  const GlxContext gl;
  Application application;
  application.start(gl);
  application.get_focused();
  EXPECT_EQ(application.frame().end_result, XR_SESSION_LOSS_PENDING);
  application.poll();
  EXPECT_EQ(application.state(), XR_SESSION_STATE_LOSS_PENDING);
  application.destroy_session();
}

TEST_F(OpenXrSessionTest, IsLostAtOnce) {
  const ScriptedHeadset headset(
      R"({"real_time": false, "events": [{"time": 0, "event": "session_lost"}]})");
  const GlxContext gl;
  Application application;
  application.start(gl);
  application.get_focused();
  SeenFrame seen;
  EXPECT_EQ(application.wait(seen), XR_ERROR_SESSION_LOST);
  EXPECT_EQ(xrRequestExitSession(application.session()), XR_ERROR_SESSION_LOST);
  application.destroy_session();
}

TEST_F(OpenXrSessionTest, AnotherSessionHasItsOwnEvents) {
  const ScriptedHeadset headset(
      R"({"real_time": false, "events": [{"time": 0, "event": "instance_loss"},
                                         {"time": 0, "event": "exit", "session": 2}]})");
  const GlxContext gl;
  {
    Application application;
    application.start(gl);
    application.get_focused();
    application.frame();
    EXPECT_THAT(types_of(application.poll()),
                IsSupersetOf({XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING}));
  }
  Application again;
  again.start(gl);
  again.get_focused();
  EXPECT_EQ(again.frame().end_result, XR_SUCCESS);
  again.poll();
  EXPECT_EQ(again.state(), XR_SESSION_STATE_EXITING);
}

TEST_F(OpenXrSessionTest, RendersNothingInSomeFrames) {
  const ScriptedHeadset headset(
      R"({"real_time": false, "refresh_hz": 10, "no_render": [{"from": 0.1, "to": 0.2}]})");
  const GlxContext gl;
  Application application;
  application.start(gl);
  application.get_focused();
  EXPECT_EQ(application.frame().state.shouldRender, XR_TRUE);
  EXPECT_EQ(application.frame().state.shouldRender, XR_FALSE);
  EXPECT_EQ(application.frame().state.shouldRender, XR_TRUE);
  EXPECT_THAT(headset.log("frame").at(4)["layers"], IsEmpty());
}

TEST_F(OpenXrSessionTest, CallsFailAsScripted) {
  const ScriptedHeadset headset(R"({"real_time": false, "refresh_hz": 10, "failures": [
      {"function": "xrEndFrame", "result": "XR_ERROR_RUNTIME_FAILURE", "time": 0.1, "times": 1}]})");
  const GlxContext gl;
  Application application;
  application.start(gl);
  application.get_focused();
  EXPECT_EQ(application.frame().end_result, XR_SUCCESS);
  EXPECT_EQ(application.frame().end_result, XR_ERROR_RUNTIME_FAILURE);
  const nlohmann::json error = headset.log("error").at(0);
  EXPECT_EQ(error["function"], "xrEndFrame");
  EXPECT_EQ(error["result"], "XR_ERROR_RUNTIME_FAILURE");
  EXPECT_EQ(error["why"], "the script says so");
}

TEST(OpenXrInstanceTest, OffersWhatTheScriptSays) {
  const ScriptedHeadset headset(R"({"extensions": ["XR_KHR_opengl_enable"]})");
  std::uint32_t count = 0;
  ASSERT_EQ(xrEnumerateInstanceExtensionProperties(nullptr, 0, &count, nullptr), XR_SUCCESS);
  std::vector<XrExtensionProperties> offered(count, {XR_TYPE_EXTENSION_PROPERTIES});
  ASSERT_EQ(xrEnumerateInstanceExtensionProperties(nullptr, count, &count, offered.data()),
            XR_SUCCESS);
  std::vector<std::string> names;
  for (const XrExtensionProperties& extension : offered) {
    names.emplace_back(extension.extensionName);
  }
  EXPECT_THAT(names, ::testing::Contains("XR_KHR_opengl_enable"));
  EXPECT_THAT(names, ::testing::Not(::testing::Contains("XR_EXT_eye_gaze_interaction")));
  EXPECT_ANY_THROW(Application());
}

TEST(OpenXrInstanceTest, DescribesTheHeadset) {
  const ScriptedHeadset headset(R"({"system_name": "Pair of tins", "eyes": [
      {"recommended_px": [10, 20], "max_px": [30, 40]}, {"recommended_px": [50, 60]}]})");
  const Application application;
  XrSystemProperties properties{XR_TYPE_SYSTEM_PROPERTIES};
  XrSystemEyeGazeInteractionPropertiesEXT eyes{XR_TYPE_SYSTEM_EYE_GAZE_INTERACTION_PROPERTIES_EXT};
  properties.next = &eyes;
  ASSERT_EQ(xrGetSystemProperties(application.instance(), application.system(), &properties),
            XR_SUCCESS);
  EXPECT_STREQ(properties.systemName, "Pair of tins");
  EXPECT_EQ(eyes.supportsEyeGazeInteraction, XR_TRUE);
  std::array<XrViewConfigurationView, 2> views{
      XrViewConfigurationView{XR_TYPE_VIEW_CONFIGURATION_VIEW},
      XrViewConfigurationView{XR_TYPE_VIEW_CONFIGURATION_VIEW}};
  std::uint32_t count = 0;
  ASSERT_EQ(xrEnumerateViewConfigurationViews(application.instance(), application.system(),
                                              XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, 2, &count,
                                              views.data()),
            XR_SUCCESS);
  EXPECT_EQ(views[0].recommendedImageRectHeight, 20U);
  EXPECT_EQ(views[0].maxImageRectWidth, 30U);
  EXPECT_EQ(views[1].recommendedImageRectWidth, 50U);
  EXPECT_EQ(headset.found_invalid(), "");
}

TEST(OpenXrInstanceTest, ValidationLayerTellsWhatItFinds) {
  const ScriptedHeadset headset;
  const Application application;
  XrSystemProperties properties{};
  EXPECT_EQ(xrGetSystemProperties(application.instance(), application.system(), &properties),
            XR_ERROR_VALIDATION_FAILURE);
  EXPECT_THAT(headset.found_invalid(), HasSubstr("xrGetSystemProperties"));
}

TEST(OpenXrInstanceTest, RefusesScriptsThatMeanNothing) {
  const ScriptedHeadset headset(R"({"events": [{"tim": 0, "event": "exit"}]})");
  EXPECT_ANY_THROW(Application());
  EXPECT_THAT(headset.log("error").at(0)["why"],
              HasSubstr("it.events[0] has a key 'tim', which means nothing"));
}

}  // namespace
}  // namespace foveola::test
