#include <gtest/gtest.h>

#include "study/record/log/encodings.h"
#include "tests/study/record/bytes_from_hex.h"

namespace foveola::study {
namespace {

// Made with Python: struct.pack('<q3fI', 1234567890123, 0.6, 0.0, -0.8, 1 | 1 << 1) +
// struct.pack('<q3fI', -1, 0.0, 0.0, -1.0, 3 << 1) +
// struct.pack('<q3fI', 2**40, 0.0, 1.0, 0.0, 1 | 2 << 1)
const char* const python =
    "cb04fb711f0100009a99193f00000000cdcc4cbf03000000"
    "ffffffffffffffff0000000000000000000080bf06000000"
    "0000000000010000000000000000803f0000000005000000";

const std::vector<GazeSample> samples = {{.time = Nanoseconds(1'234'567'890'123),
                                          .direction = {0.6F, 0.0F, -0.8F},
                                          .valid = true,
                                          .mark = GazeMark::fixation},
                                         {.time = Nanoseconds(-1), .mark = GazeMark::blink},
                                         {.time = Nanoseconds(1'099'511'627'776),
                                          .direction = {0.0F, 1.0F, 0.0F},
                                          .valid = true,
                                          .mark = GazeMark::saccade}};

TEST(GazeEncoding, MatchesPythonsStruct) {
  EXPECT_EQ(encode_gaze(samples), bytes_from_hex(python));
}

TEST(GazeEncoding, ReadsWhatPythonsStructWrote) {
  const std::vector<GazeSample> read = decode_gaze(bytes_from_hex(python));
  ASSERT_EQ(read.size(), samples.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].time, samples[i].time);
    EXPECT_EQ(read[i].direction, samples[i].direction);
    EXPECT_EQ(read[i].valid, samples[i].valid);
    EXPECT_EQ(read[i].mark, samples[i].mark);
  }
  EXPECT_TRUE(decode_gaze(bytes_from_hex(python).substr(0, 23)).empty());
}

// struct.pack('<q3fI', 5, 0.6, 0.0, -0.8, 1 | 8)
TEST(GazeEncoding, KeepsThatATimeIsNotTheTrackers) {
  const std::string bytes = bytes_from_hex("05000000000000009a99193f00000000cdcc4cbf09000000");
  const GazeSample sample{.time = Nanoseconds(5),
                          .direction = {0.6F, 0.0F, -0.8F},
                          .valid = true,
                          .is_time_known = false};
  EXPECT_EQ(encode_gaze({sample}), bytes);
  EXPECT_FALSE(decode_gaze(bytes).at(0).is_time_known);
  EXPECT_TRUE(decode_gaze(encode_gaze(samples)).at(0).is_time_known);
}

}  // namespace
}  // namespace foveola::study
