// What a preview makes of the samples that its eye tracker delivers.
#include <vector>

#include "renderer/preview/preview.h"
#include "tests/matchers.h"
#include "tests/renderer/gaze/test_eye_tracker.h"
#include "tests/renderer/preview/box_room.h"

namespace foveola {
namespace {

using testing::Field;

constexpr Nanoseconds gaze_frame_time = std::chrono::milliseconds(20);

double angle_deg(const Vec3& a, const Vec3& b) { return degrees(angle_between(a, b)); }

class PreviewGaze : public testing::Test {
 protected:
  PreviewGaze() { preview_.restart("fv", 1); }

  static PreviewSettings settings() {
    PreviewSettings settings;
    settings.render.film_size = {256, 128};
    settings.render.trace.max_depth = 1;
    return settings;
  }

  const AzimuthElevation heading_{.azimuth_rad = 0.4, .elevation_rad = 0.2};
  Scene scene_ = box_room(0.2F);
  Workers workers_{2};
  PathTracer tracer_{scene_, workers_};
  ScriptedHeadTracker head_{{{.time = Nanoseconds(0), .heading = heading_}}};
  test::TestEyeTracker eye_;
  Preview preview_{tracer_, settings(), eye_, head_, workers_};
};

TEST_F(PreviewGaze, IsStraightAheadBeforeTheFirstValidOne) {
  const auto expect_ahead = [&](const FrameReport& report) {
    EXPECT_LT(angle_deg(report.gaze, direction_from(heading_)), 1e-3);
    EXPECT_FALSE(report.gaze_valid);
    EXPECT_EQ(report.gaze_age, Nanoseconds(0));
  };
  expect_ahead(preview_.render_frame(gaze_frame_time, 1));
  eye_.next.push_back({.time = gaze_frame_time, .direction = Vec3(1.0F, 0.0F, 0.0F)});
  expect_ahead(preview_.render_frame(2 * gaze_frame_time, 1));
}

TEST_F(PreviewGaze, StaysTheLastValidOneThroughABlink) {
  const Vec3 looked_at = direction_from({.azimuth_rad = 0.3});
  const Vec3 in_world = head_orientation(heading_) * looked_at;
  eye_.next.push_back({.time = gaze_frame_time, .direction = looked_at, .valid = true});
  const FrameReport open = preview_.render_frame(2 * gaze_frame_time, 1);
  EXPECT_TRUE(open.gaze_valid);
  EXPECT_EQ(open.gaze_age, gaze_frame_time);
  eye_.next.push_back({.time = 3 * gaze_frame_time, .direction = -looked_at});
  const FrameReport blink = preview_.render_frame(4 * gaze_frame_time, 1);
  EXPECT_FALSE(blink.gaze_valid);
  EXPECT_LT(angle_deg(blink.gaze, in_world), 1e-3);
  EXPECT_EQ(blink.gaze_age, 3 * gaze_frame_time);
}

TEST_F(PreviewGaze, StaysWhileNothingArrives) {
  eye_.next.push_back(
      {.time = gaze_frame_time, .direction = direction_from({.azimuth_rad = 0.3}), .valid = true});
  const FrameReport first = preview_.render_frame(gaze_frame_time, 1);
  const FrameReport second = preview_.render_frame(2 * gaze_frame_time, 1);
  EXPECT_TRUE(second.gaze_valid);
  EXPECT_EQ(second.gaze, first.gaze);
  EXPECT_EQ(second.gaze_age, gaze_frame_time);
}

/// A head that turns and tilts, and whose past is known.
class RememberedHead final : public HeadTracker {
 public:
  HeadPose pose(Nanoseconds now) override {
    return {.time = now, .heading = {.azimuth_rad = seconds(now)}, .roll_rad = 0.5};
  }
  HeadPose pose_at_gaze(Nanoseconds then, Nanoseconds /*now*/) override { return pose(then); }
};

// Eyes that stay on something while the head turns would otherwise seem to run ahead of it.
TEST_F(PreviewGaze, IsWhereTheEyeLookedInTheWorldWhenItWasSeen) {
  RememberedHead head;
  Preview preview(tracer_, settings(), eye_, head, workers_);
  preview.restart("fv", 1);
  const Vec3 looked_at = direction_from({.azimuth_rad = 0.3, .elevation_rad = 0.1});
  eye_.next.push_back({.time = gaze_frame_time, .direction = looked_at, .valid = true});
  const FrameReport report = preview.render_frame(3 * gaze_frame_time, 1);
  EXPECT_LT(angle_deg(report.gaze, head.pose(gaze_frame_time).orientation() * looked_at), 1e-3);
  EXPECT_NEAR(report.head.azimuth_rad, seconds(3 * gaze_frame_time), 1e-9);
  EXPECT_EQ(report.head_roll_rad, 0.5);
  EXPECT_EQ(preview.viewport().head(), head.pose(3 * gaze_frame_time).orientation());
}

TEST_F(PreviewGaze, StaysInTheHeadsAxesThroughABlink) {
  RememberedHead head;
  Preview preview(tracer_, settings(), eye_, head, workers_);
  preview.restart("fv", 1);
  const Vec3 looked_at = direction_from({.azimuth_rad = 0.3, .elevation_rad = 0.1});
  eye_.next.push_back({.time = gaze_frame_time, .direction = looked_at, .valid = true});
  preview.render_frame(gaze_frame_time, 1);
  eye_.next.push_back({.time = 5 * gaze_frame_time, .direction = looked_at});
  const FrameReport blink = preview.render_frame(6 * gaze_frame_time, 1);
  EXPECT_LT(angle_deg(blink.gaze, head.pose(6 * gaze_frame_time).orientation() * looked_at), 1e-3);
}

// The valid sample came and went between two frames.
TEST_F(PreviewGaze, IsTheNewestValidOneOfThoseThatArriveTogether) {
  const Vec3 looked_at = direction_from({.azimuth_rad = -0.2});
  eye_.next.push_back({.time = Nanoseconds(1), .direction = Vec3(1.0F, 0.0F, 0.0F), .valid = true});
  eye_.next.push_back({.time = Nanoseconds(2), .direction = looked_at, .valid = true});
  eye_.next.push_back({.time = Nanoseconds(3)});
  const FrameReport report = preview_.render_frame(Nanoseconds(10), 1);
  EXPECT_FALSE(report.gaze_valid);
  EXPECT_LT(angle_deg(report.gaze, head_orientation(heading_) * looked_at), 1e-3);
  EXPECT_EQ(report.gaze_age, Nanoseconds(8));
}

TEST_F(PreviewGaze, AllThatArrivesForAFrameIsReported) {
  const auto at = [](int time_ns) { return Field(&GazeSample::time, Nanoseconds(time_ns)); };
  eye_.next.push_back({.time = Nanoseconds(1), .valid = true});
  eye_.next.push_back({.time = Nanoseconds(2)});
  preview_.render_frame(Nanoseconds(3), 1);
  EXPECT_THAT(preview_.arrived_gaze(), ElementsAre(at(1), at(2)));
  preview_.render_frame(Nanoseconds(4), 1);
  EXPECT_THAT(preview_.arrived_gaze(), IsEmpty());
  eye_.next.push_back({.time = Nanoseconds(5), .valid = true});
  preview_.render_frame(Nanoseconds(6), 1);
  EXPECT_THAT(preview_.arrived_gaze(), ElementsAre(at(5)));
}

// A pursuit at 20 degrees per second, extrapolated by 50 ms, and then a blink.
TEST_F(PreviewGaze, IsFilteredWhileWhatArrivedIsReportedAsItCame) {
  PreviewSettings filtering = settings();
  filtering.gaze_filter = {.extrapolate_s = 0.05, .hold_s = 0.2};
  Preview preview(tracer_, filtering, eye_, head_, workers_);
  preview.restart("fv", 1);
  const auto seen_at = [](int number) {
    return GazeSample{.time = number * gaze_frame_time / 2,
                      .direction = direction_from({.azimuth_rad = radians(0.2 * number)}),
                      .valid = true};
  };
  FrameReport report;
  for (int number = 0; number < 20; number += 2) {
    eye_.next = {seen_at(number), seen_at(number + 1)};
    report = preview.render_frame(seen_at(number + 1).time, 1);
  }
  const Vec3 later = direction_from({.azimuth_rad = radians(0.2 * 19 + 1.0)});
  EXPECT_LT(angle_deg(report.gaze, head_orientation(heading_) * later), 1e-3);
  EXPECT_EQ(report.gaze_age, Nanoseconds(0)) << "of the sample, not of what became of it";
  ASSERT_EQ(preview.arrived_gaze().size(), 2U);
  EXPECT_EQ(preview.arrived_gaze()[1].direction, seen_at(19).direction);
  eye_.next = {{.time = seen_at(20).time}};
  const FrameReport blink = preview.render_frame(seen_at(20).time, 1);
  EXPECT_TRUE(blink.gaze_valid) << "held";
  EXPECT_EQ(blink.gaze, report.gaze);
  EXPECT_EQ(blink.gaze_age, gaze_frame_time / 2);
  ASSERT_EQ(preview.arrived_gaze().size(), 1U);
  EXPECT_FALSE(preview.arrived_gaze()[0].valid);
}

}  // namespace
}  // namespace foveola
