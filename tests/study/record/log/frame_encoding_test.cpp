#include <gtest/gtest.h>

#include "renderer/base/angles.h"
#include "renderer/gaze/head_tracker.h"
#include "study/record/log/encodings.h"
#include "tests/study/record/bytes_from_hex.h"

namespace foveola::study {
namespace {

// Made with Python: struct.pack('<qq5fqII', 1234567890123, 1234567899999, 0.5, -0.25, 0.6, 0.0,
// -0.8, 14000000, 100000, 1 | 4) + struct.pack('<qq5fqII', -1, -2, 3.140625, 1.5, 0.0, 1.0, 0.0,
// 2**40, 4294967295, 2)
const char* const frames_of_python =
    "cb04fb711f0100005f2bfb711f0100000000003f000080be9a99193f00000000cdcc4cbf809fd500"
    "00000000a086010005000000"
    "fffffffffffffffffeffffffffffffff000049400000c03f000000000000803f0000000000000000"
    "00010000ffffffff02000000";

const std::vector<FrameRow> two_frames = {{.time = Nanoseconds(1'234'567'890'123),
                                           .presented = Nanoseconds(1'234'567'899'999),
                                           .head_azimuth_rad = 0.5F,
                                           .head_elevation_rad = -0.25F,
                                           .gaze = {0.6F, 0.0F, -0.8F},
                                           .gaze_valid = true,
                                           .is_late = true,
                                           .gaze_age = Nanoseconds(14'000'000),
                                           .samples = 100'000},
                                          {.time = Nanoseconds(-1),
                                           .presented = Nanoseconds(-2),
                                           .head_azimuth_rad = 3.140625F,
                                           .head_elevation_rad = 1.5F,
                                           .gaze = {0.0F, 1.0F, 0.0F},
                                           .gaze_valid = false,
                                           .gaze_held = true,
                                           .gaze_age = Nanoseconds(1'099'511'627'776),
                                           .samples = 4'294'967'295U}};

void expect_same(const FrameRow& frame, const FrameRow& expected) {
  EXPECT_EQ(frame.time, expected.time);
  EXPECT_EQ(frame.presented, expected.presented);
  EXPECT_EQ(frame.head_azimuth_rad, expected.head_azimuth_rad);
  EXPECT_EQ(frame.head_elevation_rad, expected.head_elevation_rad);
  EXPECT_EQ(frame.gaze, expected.gaze);
  EXPECT_EQ(frame.gaze_valid, expected.gaze_valid);
  EXPECT_EQ(frame.gaze_held, expected.gaze_held);
  EXPECT_EQ(frame.is_late, expected.is_late);
  EXPECT_EQ(frame.gaze_age, expected.gaze_age);
  EXPECT_EQ(frame.samples, expected.samples);
  EXPECT_EQ(frame.head_roll_rad, expected.head_roll_rad);
}

TEST(FrameEncoding, MatchesPythonsStruct) {
  EXPECT_EQ(encode_frames(two_frames), bytes_from_hex(frames_of_python));
}

TEST(FrameEncoding, ReadsWhatPythonsStructWrote) {
  const std::vector<FrameRow> frames =
      decode_frames("frames-3", bytes_from_hex(frames_of_python) + "half a frame");
  ASSERT_EQ(frames.size(), 2U);
  expect_same(frames[0], two_frames[0]);
  expect_same(frames[1], two_frames[1]);
}

// struct.pack('<qq5fqII', 5, 6, 0.5, -0.25, 0.6, 0.0, -0.8, 7, 8, (-4096 & 0xffff) << 16)
TEST(FrameEncoding, KeepsHowFarTheHeadIsTilted) {
  const std::string bytes = bytes_from_hex(
      "050000000000000006000000000000000000003f000080be9a99193f00000000cdcc4cbf07000000000000000800"
      "0000000000f0");
  const FrameRow tilted{.time = Nanoseconds(5),
                        .presented = Nanoseconds(6),
                        .head_azimuth_rad = 0.5F,
                        .head_elevation_rad = -0.25F,
                        .head_roll_rad = static_cast<float>(-radians(22.5)),
                        .gaze = {0.6F, 0.0F, -0.8F},
                        .gaze_age = Nanoseconds(7),
                        .samples = 8};
  EXPECT_EQ(encode_frames({tilted}), bytes);
  expect_same(decode_frames("frames-3", bytes).at(0), tilted);
}

TEST(FrameEncoding, KeepsATrackedHeadsRollAsItWasUsed) {
  for (int i = -180; i <= 180; ++i) {
    const double roll_rad = head_pose({}, head_orientation({}, radians(i))).roll_rad;
    FrameRow frame{.head_roll_rad = static_cast<float>(roll_rad)};
    const FrameRow kept = decode_frames("frames-3", encode_frames({frame})).at(0);
    EXPECT_EQ(head_orientation({}, kept.head_roll_rad), head_orientation({}, roll_rad)) << i;
  }
}

// struct.pack('<q5fqII', 1234567890123, 0.5, -0.25, 0.6, 0.0, -0.8, 14000000, 100000, 1)
TEST(FrameEncoding, ReadsTheFramesOfOlderSchemas) {
  const std::vector<FrameRow> frames = decode_frames(
      "frames-2",
      bytes_from_hex(
          "cb04fb711f0100000000003f000080be9a99193f00000000cdcc4cbf809fd50000000000a0860100"
          "01000000"));
  ASSERT_EQ(frames.size(), 1U);
  FrameRow expected = two_frames[0];
  expected.presented = expected.time;
  expected.is_late = false;
  expect_same(frames[0], expected);
}

}  // namespace
}  // namespace foveola::study
