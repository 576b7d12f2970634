#include "renderer/gaze/recordings.h"

#include <string>

#include "renderer/base/angles.h"
#include "renderer/base/files/files.h"
#include "renderer/base/numbers/random.h"
#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/renderer/gaze/newest_gaze.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;
using test::polled;
using test::TemporaryFolder;

const std::string header = "time_ns,x,y,z,valid\n";

std::vector<GazeSample> read(const std::string& content) {
  const TemporaryFolder folder;
  return read_gaze_file(folder.write("gaze.csv", content));
}

std::string error_of(const std::string& content) {
  return test::error_of([&] { read(content); });
}

TEST(GazeFile, IsReadAsItIsDescribed) {
  const auto samples = read(header + "0,0.6,0,-0.8,1\n8333333,,,,0\r\n16666667,-1e0,0,0,1");
  ASSERT_EQ(samples.size(), 3U);
  EXPECT_EQ(samples[0].time, Nanoseconds(0));
  EXPECT_EQ(samples[0].direction, Vec3(0.6F, 0.0F, -0.8F));
  EXPECT_TRUE(samples[0].valid);
  EXPECT_EQ(samples[1].time, Nanoseconds(8333333));
  EXPECT_FALSE(samples[1].valid);
  EXPECT_EQ(samples[2].direction, Vec3(-1.0F, 0.0F, 0.0F));
}

TEST(GazeFile, ANearlyUnitDirectionIsMadeOne) {
  const auto samples = read(header + "0,0.0006,0,-0.9995,1\n");
  EXPECT_NEAR(glm::length(samples[0].direction), 1.0F, 1e-6F);
}

TEST(GazeFile, IsWrittenAsItIsDescribed) {
  const TemporaryFolder folder;
  const std::vector<GazeSample> samples{
      {.time = Nanoseconds(5), .direction = {0.0F, 1.0F, 0.0F}, .valid = true},
      {.time = Nanoseconds(7), .direction = {0.0F, 1.0F, 0.0F}}};
  write_gaze_file(folder / "gaze.csv", samples);
  EXPECT_EQ(read_file(folder / "gaze.csv"), header + "5,0,1,0,1\n7,,,,0\n");
  EXPECT_EQ(std::filesystem::status(folder / "gaze.csv").permissions(),
            std::filesystem::perms(0600));
}

TEST(GazeFile, BringsSamplesBackBitForBit) {
  const TemporaryFolder folder;
  Pcg32 random(2);
  std::vector<GazeSample> samples;
  for (int i = 0; i < 5000; ++i) {
    GazeSample sample{.time = i * Nanoseconds(8'333'333), .valid = random.below(10) > 0};
    if (sample.valid) {
      const double azimuth_rad = 6.0 * random.uniform() - 3.0;
      const double elevation_rad = 3.0 * random.uniform() - 1.5;
      sample.direction =
          direction_from({.azimuth_rad = azimuth_rad, .elevation_rad = elevation_rad});
    }
    samples.push_back(sample);
  }
  write_gaze_file(folder / "gaze.csv", samples);
  const auto back = read_gaze_file(folder / "gaze.csv");
  ASSERT_EQ(back.size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_EQ(back[i].time, samples[i].time);
    ASSERT_EQ(back[i].valid, samples[i].valid);
    ASSERT_EQ(back[i].direction, samples[i].direction);
  }
}

TEST(GazeFile, ErrorsSayWhere) {
  EXPECT_THAT(error_of(""), HasSubstr("gaze.csv:1: is not the first line"));
  EXPECT_THAT(error_of("time_ns,azimuth_deg,elevation_deg,valid\n"), HasSubstr("gaze.csv:1: "));
  EXPECT_THAT(error_of(header), HasSubstr("gaze.csv: has no samples"));
  const std::string good = header + "0,0,0,-1,1\n";
  struct Case {
    const char* line;
    const char* what;
  };
  for (const Case& c : {Case{"1,0,0,-1", "has 4 fields instead of 5"},
                        {"1,0,0,-1,1,", "has 6 fields instead of 5"},
                        {"", "has 1 fields instead of 5"},
                        {"-1,0,0,-1,1", "\"-1\" is not a number from 0 to"},
                        {"1.5,0,0,-1,1", "\"1.5\" is not a number"},
                        {"9223372036854775808,0,0,-1,1", "is not a number"},
                        {",0,0,-1,1", "\"\" is not a number"},
                        {"1,0,0,nan,1", "\"nan\" is not a number from -2 to 2"},
                        {"1,0,0,-1 ,1", "\"-1 \" is not a number"},
                        {"1,0,0,,1", "\"\" is not a number"},
                        {"1,0,0,-0.9,1", "the direction has length 0.9"},
                        {"1,0,0,0,1", "the direction has length 0"},
                        {"1,0,0,-1,0", "an invalid sample has a direction"},
                        {"1,0,0,-1,2", "valid is \"2\""},
                        {"1,0,0,-1,", "valid is \"\""},
                        {"0,0,0,-1,1", "is not later than the line before"}}) {
    EXPECT_THAT(error_of(good + c.line + "\n"), AllOf(HasSubstr("gaze.csv:3: "), HasSubstr(c.what)))
        << c.line;
  }
  EXPECT_THROW(read_gaze_file("/nowhere/gaze.csv"), Error);
}

TEST(GazeFile, WhatCouldNotBeReadIsNotWritten) {
  const TemporaryFolder folder;
  const Vec3 ahead(0.0F, 0.0F, -1.0F);
  using Samples = std::vector<GazeSample>;
  for (const Samples& bad : {Samples{}, Samples{{.time = Nanoseconds(-1)}},
                             Samples{{.time = Nanoseconds(1)}, {.time = Nanoseconds(1)}},
                             Samples{{.direction = 0.5F * ahead, .valid = true}}}) {
    EXPECT_THROW(write_gaze_file(folder / "gaze.csv", bad), Error);
  }
  EXPECT_TRUE(folder.entries().empty());
}

std::vector<GazeSample> three_samples() {
  const Vec3 right(1.0F, 0.0F, 0.0F);
  return {{.time = milliseconds(10), .valid = true},
          {.time = milliseconds(20)},
          {.time = milliseconds(35), .direction = right, .valid = true}};
}

TEST(RecordedEyeTracker, DeliversEachSampleOnceAtItsTimeAndTheLatency) {
  RecordedEyeTracker tracker(three_samples(), milliseconds(1000), milliseconds(5));
  EXPECT_TRUE(polled(tracker, milliseconds(1015) - Nanoseconds(1)).empty());
  const auto first = polled(tracker, milliseconds(1015));
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].time, milliseconds(1010));
  EXPECT_TRUE(first[0].valid);
  EXPECT_TRUE(polled(tracker, milliseconds(1024)).empty());
  const auto rest = polled(tracker, milliseconds(5000));
  ASSERT_EQ(rest.size(), 2U);
  EXPECT_EQ(rest[0].time, milliseconds(1020));
  EXPECT_FALSE(rest[0].valid);
  EXPECT_EQ(rest[1].time, milliseconds(1035));
  EXPECT_EQ(rest[1].direction, Vec3(1.0F, 0.0F, 0.0F));
  EXPECT_TRUE(polled(tracker, milliseconds(9000)).empty());
}

TEST(RecordedEyeTracker, WithoutSamplesDeliversNone) {
  RecordedEyeTracker tracker({}, Nanoseconds(0), Nanoseconds(0));
  EXPECT_TRUE(polled(tracker, milliseconds(1)).empty());
}

TEST(Replayable, CountsFromTheFirstSampleAndLeavesOutWhatStepsBack) {
  std::vector<GazeSample> arrived = three_samples();
  arrived.insert(arrived.begin() + 2, {.time = milliseconds(15), .valid = true});
  arrived.insert(arrived.begin() + 3, {.time = milliseconds(20), .valid = true});
  const auto samples = replayable(arrived);
  ASSERT_EQ(samples.size(), 3U);
  EXPECT_EQ(samples[0].time, milliseconds(0));
  EXPECT_TRUE(samples[0].valid);
  EXPECT_EQ(samples[1].time, milliseconds(10));
  EXPECT_FALSE(samples[1].valid);
  EXPECT_EQ(samples[2].time, milliseconds(25));
  EXPECT_TRUE(replayable({}).empty());
}

TEST(RecordedEyeTracker, NeedsTimesInOrder) {
  std::vector<GazeSample> samples = three_samples();
  samples[2].time = samples[1].time;
  EXPECT_THROW(RecordedEyeTracker(samples, Nanoseconds(0), Nanoseconds(0)), Error);
}

}  // namespace
}  // namespace foveola
