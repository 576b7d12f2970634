#include "study/record/setup/session_devices.h"

#include <gtest/gtest.h>

namespace foveola::study {
namespace {

constexpr const char* headset =
    R"({"display":{"profile":"fove0","framebuffer":[2560,1440],"horizontal_fov_deg":100.0,)"
    R"("vertical_fov_deg":90,"lens":[0.5,0.25,0.125,0.0]},"tracker":{"profile":"camera"}})";

TEST(SessionDevices, SayTheViewAndTheTracker) {
  const FieldOfView view = field_of_view_in(headset).value();
  EXPECT_EQ(view.horizontal_deg, 100.0);
  EXPECT_EQ(view.vertical_deg, 90.0);
  EXPECT_EQ(view.lens, (RadialLens{.axis = {0.5F, 0.25F}, .k1 = 0.125F, .k2 = 0.0F}));
  EXPECT_EQ(tracker_in(headset), "camera");
}

TEST(SessionDevices, AViewWithoutALensIsFlat) {
  const FieldOfView view =
      field_of_view_in(R"({"display":{"horizontal_fov_deg":50,"vertical_fov_deg":30}})").value();
  EXPECT_EQ(view.lens, RadialLens{});
  EXPECT_EQ(view.seen, nullptr) << "all of it";
}

TEST(SessionDevices, SayWhatIsSeenOfAView) {
  const FieldOfView view =
      field_of_view_in(
          R"({"display":{"horizontal_fov_deg":50,"vertical_fov_deg":30,"seen":["7e","ff"]}})")
          .value();
  EXPECT_EQ(view.seen->rows(), (std::vector<std::string>{"7e", "ff"}));
}

TEST(SessionDevices, WhatIsNotSaidIsNotGuessed) {
  for (const char* devices :
       {"{}", "no JSON", "[]", R"({"display":3})", R"({"display":{"horizontal_fov_deg":50}})",
        R"({"display":{"horizontal_fov_deg":"50","vertical_fov_deg":30}})",
        R"({"display":{"horizontal_fov_deg":0,"vertical_fov_deg":30}})",
        R"({"display":{"horizontal_fov_deg":50,"vertical_fov_deg":180}})",
        R"({"display":{"horizontal_fov_deg":90,"vertical_fov_deg":90,"lens":[0.5,0.5,-9,0]}})",
        R"({"display":{"horizontal_fov_deg":90,"vertical_fov_deg":90,"lens":[0.5,0.5]}})",
        R"({"display":{"horizontal_fov_deg":50,"vertical_fov_deg":30,"seen":["7e",3]}})",
        R"({"display":{"horizontal_fov_deg":50,"vertical_fov_deg":30,"seen":"7e"}})",
        R"({"display":{"horizontal_fov_deg":50,"vertical_fov_deg":30,"seen":[]}})",
        R"({"tracker":{"profile":7}})"}) {
    EXPECT_FALSE(field_of_view_in(devices)) << devices;
    EXPECT_EQ(tracker_in(devices), "") << devices;
  }
}

TEST(SessionDevices, SayWhatTracedTheRays) {
  const std::string devices = with_renderer(R"({"keys":{}})", {.version = "1",
                                                               .ray_tracer = "Embree 9",
                                                               .instruction_set = "x86-64-v3",
                                                               .ray_instructions = "avx2"});
  EXPECT_EQ(devices,
            R"({"keys":{},"renderer":{"ray_tracer":"Embree 9","instruction_set":"x86-64-v3",)"
            R"("ray_instructions":"avx2"}})");
  const BuildInfo build = with_renderer_in(devices, {.version = "2"});
  EXPECT_EQ(exact_name(build), "Foveola 2 (Embree 9) with x86-64-v3 and rays by avx2");
  EXPECT_EQ(with_renderer("{}", {}), "{}");
  EXPECT_EQ(exact_name(with_renderer_in("{}", build)), "Foveola 2");
}

TEST(SessionDevices, AreInTheNoteOfASessionThatGoesOn) {
  EXPECT_EQ(note_of_devices("{}"), "goes on with {}");
  EXPECT_EQ(devices_in_note(note_of_devices(headset)), headset);
  EXPECT_FALSE(devices_in_note("goes on with another screen"));
  EXPECT_FALSE(devices_in_note("glasses"));
}

}  // namespace
}  // namespace foveola::study
