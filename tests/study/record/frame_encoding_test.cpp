#include "study/record/frame_encoding.h"

#include <gtest/gtest.h>

#include "bytes_from_hex.h"

namespace foveola::study {
namespace {

// Made with Python: struct.pack('<q5fqII', 1234567890123, 0.5, -0.25, 0.6, 0.0, -0.8, 14000000,
// 100000, 1) + struct.pack('<q5fqII', -1, 3.140625, 1.5, 0.0, 1.0, 0.0, 2**40, 4294967295, 2)
TEST(FrameEncoding, MatchesPythonsStruct) {
  const std::vector<FrameRow> frames = {{.time = Nanoseconds(1'234'567'890'123),
                                         .head_azimuth_rad = 0.5F,
                                         .head_elevation_rad = -0.25F,
                                         .gaze = {0.6F, 0.0F, -0.8F},
                                         .gaze_valid = true,
                                         .gaze_age = Nanoseconds(14'000'000),
                                         .samples = 100'000},
                                        {.time = Nanoseconds(-1),
                                         .head_azimuth_rad = 3.140625F,
                                         .head_elevation_rad = 1.5F,
                                         .gaze = {0.0F, 1.0F, 0.0F},
                                         .gaze_valid = false,
                                         .gaze_held = true,
                                         .gaze_age = Nanoseconds(1'099'511'627'776),
                                         .samples = 4'294'967'295U}};
  const std::string expected = bytes_from_hex(
      "cb04fb711f0100000000003f000080be9a99193f00000000cdcc4cbf809fd50000000000a086010001000000"
      "ffffffffffffffff000049400000c03f000000000000803f000000000000000000010000ffffffff02000000");
  EXPECT_EQ(encode_frames(frames), expected);
  EXPECT_EQ(encode_frames({{.gaze_valid = true, .gaze_held = true}}).substr(40),
            std::string("\3\0\0\0", 4));
}

}  // namespace
}  // namespace foveola::study
