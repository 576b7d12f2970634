// What an application submits, and what the runtime does not take.
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

/// A focused application. What it does wrong is left to the runtime.
class OpenXrSubmissionTest : public ::testing::Test {
 protected:
  explicit OpenXrSubmissionTest(
      ScriptedHeadset::Validation validation = ScriptedHeadset::Validation::off)
      : headset(R"({"real_time": false, "save_frames": [1]})", validation) {
    application.emplace();
    application->start(gl);
    application->get_focused();
  }
  ~OpenXrSubmissionTest() override { application->destroy_session(); }

  /// The latest refusal: "function result: why".
  std::string refusal() {
    const nlohmann::json error = headset.log("error").back();
    return error["function"].get<std::string>() + " " + error["result"].get<std::string>() + ": " +
           error["why"].get<std::string>();
  }

  XServer server;
  ScriptedHeadset headset;
  GlxContext gl;
  std::optional<Application> application;
};

class OpenXrGoodSubmissionTest : public OpenXrSubmissionTest {
 protected:
  OpenXrGoodSubmissionTest() : OpenXrSubmissionTest(ScriptedHeadset::Validation::on) {}
};

TEST_F(OpenXrGoodSubmissionTest, IsInTheLog) {
  const SeenFrame seen = application->frame();
  EXPECT_EQ(seen.end_result, XR_SUCCESS);
  const nlohmann::json frame = headset.log("frame").back();
  EXPECT_EQ(frame["display_time"], seen.state.predictedDisplayTime);
  EXPECT_EQ(frame["predicted_display_time"], seen.state.predictedDisplayTime);
  ASSERT_EQ(frame["layers"].size(), 1U);
  const nlohmann::json layer = frame["layers"][0];
  EXPECT_EQ(layer["space"], "LOCAL");
  ASSERT_EQ(layer["views"].size(), 2U);
  EXPECT_NEAR(layer["views"][0]["position_m"][0].get<double>(), -0.0315, 1e-6);
  EXPECT_NEAR(layer["views"][1]["fov_deg"]["right"].get<double>(), 46.0, 1e-4);
  EXPECT_EQ(layer["views"][0]["rect"], nlohmann::json({0, 0, 32, 36}));
  EXPECT_NE(layer["views"][0]["swapchain"], layer["views"][1]["swapchain"]);
  EXPECT_EQ(headset.log("swapchain").at(0)["width"], 32);
  EXPECT_THAT(headset.log("error"), IsEmpty());
  EXPECT_EQ(headset.found_invalid(), "");
}

TEST_F(OpenXrGoodSubmissionTest, PicturesAreSaved) {
  application->frame();
  const auto submit_a_part = [](Submission& submission) {
    submission.views[1].subImage.imageRect = {{4, 26}, {20, 10}};
  };
  EXPECT_EQ(application->frame(submit_a_part).end_result, XR_SUCCESS);
  application->frame();
  const std::map<std::string, std::string> pictures = headset.pictures();
  ASSERT_EQ(pictures.size(), 2U);
  const std::string green("\0\xff\0", 3);
  const std::string header = "P6\n32 36\n255\n";
  const std::string& left = pictures.at("1-0.ppm");
  ASSERT_EQ(left.substr(0, header.size()), header);
  EXPECT_EQ(left.size(), header.size() + 3U * 32U * 36U);
  EXPECT_EQ(left.substr(header.size(), 3), green);
  EXPECT_EQ(left.substr(left.size() - 3), std::string("\xff\0\0", 3));
  const std::string& right = pictures.at("1-1.ppm");
  ASSERT_EQ(right.substr(0, header.size()), "P6\n20 10\n255\n");
  EXPECT_EQ(right.size(), header.size() + 3U * 20U * 10U);
  EXPECT_EQ(right.substr(header.size(), 3), green);
  EXPECT_EQ(right.substr(right.size() - 3), std::string("\0\0\xff", 3));
}

TEST_F(OpenXrSubmissionTest, OfAnotherPoseIsRefused) {
  EXPECT_EQ(
      application->frame([](Submission& s) { s.views[0].pose.position.x += 0.01F; }).end_result,
      XR_ERROR_LAYER_INVALID);
  EXPECT_EQ(refusal(),
            "xrEndFrame XR_ERROR_LAYER_INVALID: view 0 has another pose than was located for this "
            "frame in the layer's space");
}

TEST_F(OpenXrSubmissionTest, OfSwappedEyesIsRefused) {
  EXPECT_EQ(application->frame([](Submission& s) { std::swap(s.views[0].pose, s.views[1].pose); })
                .end_result,
            XR_ERROR_LAYER_INVALID);
  EXPECT_THAT(refusal(), HasSubstr("view 0 has the other eye's pose"));
}

TEST_F(OpenXrSubmissionTest, OfSwappedFieldsOfViewIsRefused) {
  EXPECT_EQ(application->frame([](Submission& s) { std::swap(s.views[0].fov, s.views[1].fov); })
                .end_result,
            XR_ERROR_LAYER_INVALID);
  EXPECT_THAT(refusal(), HasSubstr("view 0 has the other eye's field of view"));
}

TEST_F(OpenXrSubmissionTest, OfAnotherTimeIsRefused) {
  EXPECT_EQ(application->frame([](Submission& s) { s.display_time += 5; }).end_result,
            XR_ERROR_TIME_INVALID);
  EXPECT_THAT(refusal(), HasSubstr("the display time is 5 ns from the frame's"));
}

TEST_F(OpenXrSubmissionTest, OfARectangleOutsideIsRefused) {
  EXPECT_EQ(application->frame([](Submission& s) { s.views[1].subImage.imageRect.offset.x = 1; })
                .end_result,
            XR_ERROR_SWAPCHAIN_RECT_INVALID);
}

TEST_F(OpenXrSubmissionTest, OfOneViewIsRefused) {
  EXPECT_EQ(application->frame([](Submission& s) { s.views.pop_back(); }).end_result,
            XR_ERROR_VALIDATION_FAILURE);
}

TEST_F(OpenXrSubmissionTest, OfAQuaternionOfAnotherLengthIsRefused) {
  EXPECT_EQ(
      application->frame([](Submission& s) { s.views[0].pose.orientation.w = 2.0F; }).end_result,
      XR_ERROR_POSE_INVALID);
}

TEST_F(OpenXrSubmissionTest, OfAnImageStillDrawnOnIsRefused) {
  const XrSwapchain swapchain = application->swapchain(0);
  const auto acquire_again = [&](Submission&) {
    std::uint32_t index = 0;
    XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO};
    EXPECT_EQ(xrAcquireSwapchainImage(swapchain, nullptr, &index), XR_SUCCESS);
    EXPECT_EQ(xrWaitSwapchainImage(swapchain, &wait), XR_SUCCESS);
  };
  EXPECT_EQ(application->frame(acquire_again).end_result, XR_ERROR_LAYER_INVALID);
  EXPECT_THAT(refusal(), HasSubstr("an image is still being drawn on"));
}

TEST_F(OpenXrSubmissionTest, OfADestroyedSwapchainIsRefused) {
  const XrSwapchain swapchain = application->swapchain(1);
  const auto destroy = [&](Submission&) { EXPECT_EQ(xrDestroySwapchain(swapchain), XR_SUCCESS); };
  EXPECT_EQ(application->frame(destroy).end_result, XR_ERROR_HANDLE_INVALID);
  EXPECT_THAT(refusal(), HasSubstr("the swapchain was destroyed"));
}

TEST_F(OpenXrSubmissionTest, OfViewsThatWereNotLocatedIsRefused) {
  SeenFrame seen = application->frame();
  ASSERT_EQ(application->wait(seen), XR_SUCCESS);
  ASSERT_EQ(xrBeginFrame(application->session(), nullptr), XR_SUCCESS);
  EXPECT_EQ(application->submit(seen, {}), XR_ERROR_LAYER_INVALID);
  EXPECT_THAT(refusal(), HasSubstr("the views were not located for this frame"));
}

TEST_F(OpenXrSubmissionTest, CallsOutOfOrderAreRefused) {
  const XrSession session = application->session();
  EXPECT_EQ(xrBeginFrame(session, nullptr), XR_ERROR_CALL_ORDER_INVALID);
  EXPECT_EQ(application->submit(SeenFrame(), {}), XR_ERROR_CALL_ORDER_INVALID);
  EXPECT_EQ(xrReleaseSwapchainImage(application->swapchain(0), nullptr),
            XR_ERROR_CALL_ORDER_INVALID);
  SeenFrame seen;
  EXPECT_EQ(application->wait(seen), XR_SUCCESS);
  EXPECT_EQ(application->wait(seen), XR_ERROR_CALL_ORDER_INVALID);
  EXPECT_THAT(refusal(), HasSubstr("a headset would wait for ever"));
}

TEST_F(OpenXrSubmissionTest, FramesThatAreNotEndedAreDiscarded) {
  SeenFrame seen;
  ASSERT_EQ(application->wait(seen), XR_SUCCESS);
  ASSERT_EQ(xrBeginFrame(application->session(), nullptr), XR_SUCCESS);
  ASSERT_EQ(application->wait(seen), XR_SUCCESS);
  EXPECT_EQ(xrBeginFrame(application->session(), nullptr), XR_FRAME_DISCARDED);
  EXPECT_EQ(headset.log("discarded").at(0)["frame"], 0);
}

TEST_F(OpenXrSubmissionTest, TimesOfNoClockAreRefused) {
  XrViewLocateInfo info{XR_TYPE_VIEW_LOCATE_INFO};
  info.viewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
  info.space = application->local();
  XrViewState state{XR_TYPE_VIEW_STATE};
  std::uint32_t count = 0;
  EXPECT_EQ(xrLocateViews(application->session(), &info, &state, 0, &count, nullptr),
            XR_ERROR_TIME_INVALID);
  timespec system{};
  ::clock_gettime(CLOCK_MONOTONIC, &system);
  info.displayTime = static_cast<XrTime>(system.tv_sec) * 1'000'000'000 + 1;
  EXPECT_EQ(xrLocateViews(application->session(), &info, &state, 0, &count, nullptr),
            XR_ERROR_TIME_INVALID);
  EXPECT_THAT(refusal(), HasSubstr("as another clock's would be"));
}

TEST_F(OpenXrSubmissionTest, ArraysThatAreTooShortAreRefused) {
  std::array<std::int64_t, 1> formats{};
  std::uint32_t count = 0;
  EXPECT_EQ(xrEnumerateSwapchainFormats(application->session(), 1, &count, formats.data()),
            XR_ERROR_SIZE_INSUFFICIENT);
  EXPECT_GT(count, 1U);
}

TEST_F(OpenXrSubmissionTest, ActionSetsThatAreNotAttachedAreRefused) {
  XrActionSetCreateInfo info{XR_TYPE_ACTION_SET_CREATE_INFO};
  std::string("other").copy(info.actionSetName, sizeof(info.actionSetName));
  std::string("Other").copy(info.localizedActionSetName, sizeof(info.localizedActionSetName));
  XrActiveActionSet active{};
  ASSERT_EQ(xrCreateActionSet(application->instance(), &info, &active.actionSet), XR_SUCCESS);
  XrActionsSyncInfo sync{XR_TYPE_ACTIONS_SYNC_INFO};
  sync.countActiveActionSets = 1;
  sync.activeActionSets = &active;
  EXPECT_EQ(xrSyncActions(application->session(), &sync), XR_ERROR_ACTIONSET_NOT_ATTACHED);
}

/// An instance that has no session yet.
class OpenXrBindingTest : public ::testing::Test {
 protected:
  XrResult create(const std::function<void(XrGraphicsBindingOpenGLXlibKHR&)>& spoil = {}) {
    XrGraphicsBindingOpenGLXlibKHR binding = gl.binding();
    if (spoil) {
      spoil(binding);
    }
    XrSessionCreateInfo info{XR_TYPE_SESSION_CREATE_INFO};
    info.next = &binding;
    info.systemId = application.system();
    XrSession session = XR_NULL_HANDLE;
    return xrCreateSession(application.instance(), &info, &session);
  }
  void ask_requirements() const {
    XrGraphicsRequirementsOpenGLKHR requirements{XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR};
    application.function<PFN_xrGetOpenGLGraphicsRequirementsKHR>(
        "xrGetOpenGLGraphicsRequirementsKHR")(application.instance(), application.system(),
                                              &requirements);
  }

  XServer server;
  ScriptedHeadset headset{"{}", ScriptedHeadset::Validation::off};
  GlxContext gl;
  Application application;
};

TEST_F(OpenXrBindingTest, NeedsTheRequirementsToBeAskedFor) {
  EXPECT_EQ(create(), XR_ERROR_GRAPHICS_REQUIREMENTS_CALL_MISSING);
  ask_requirements();
  EXPECT_EQ(create(), XR_SUCCESS);
  EXPECT_EQ(create(), XR_ERROR_LIMIT_REACHED);
}

TEST_F(OpenXrBindingTest, NeedsAllOfGlx) {
  ask_requirements();
  constexpr XrResult invalid = XR_ERROR_GRAPHICS_DEVICE_INVALID;
  EXPECT_EQ(create([](auto& binding) { binding.glxFBConfig = nullptr; }), invalid);
  EXPECT_EQ(create([](auto& binding) { binding.glxDrawable = 0; }), invalid);
  EXPECT_EQ(create([](auto& binding) { binding.glxContext = nullptr; }), invalid);
  EXPECT_EQ(create([](auto& binding) { binding.xDisplay = nullptr; }), invalid);
  EXPECT_EQ(create([](auto& binding) { binding.visualid = 0; }), invalid);
  std::vector<std::string> reasons;
  for (const nlohmann::json& line : headset.log("error")) {
    reasons.push_back(line["why"]);
  }
  EXPECT_THAT(reasons, ElementsAre("the binding has no GLXFBConfig", "the binding has no drawable",
                                   "the binding has no context", "the binding has no display",
                                   "the binding has no visual"));
}

}  // namespace
}  // namespace foveola::test
