#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/numbers/random.h"
#include "renderer/gaze/recordings.h"
#include "tests/error_of.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

using std::chrono::milliseconds;
using test::TemporaryFolder;

const std::string head_header = "time_ns,azimuth_rad,elevation_rad\n";

std::vector<HeadPose> read_head(const std::string& content) {
  const TemporaryFolder folder;
  return read_head_file(folder.write("head.csv", content));
}

std::string head_error_of(const std::string& content) {
  return test::error_of([&] { read_head(content); });
}

TEST(HeadFile, IsReadAsItIsDescribed) {
  const auto poses =
      read_head(head_header + "0,1.5,0\n14285714,-7e0,-0.25\r\n28571428,0,1.5707963267948966");
  ASSERT_EQ(poses.size(), 3U);
  EXPECT_EQ(poses[0].time, Nanoseconds(0));
  EXPECT_EQ(poses[0].heading.azimuth_rad, 1.5);
  EXPECT_EQ(poses[1].time, Nanoseconds(14285714));
  EXPECT_EQ(poses[1].heading.azimuth_rad, -7.0);
  EXPECT_EQ(poses[1].heading.elevation_rad, -0.25);
  EXPECT_EQ(poses[2].heading.elevation_rad, 0.5 * std::numbers::pi);
}

TEST(HeadFile, MayHaveRoll) {
  const auto poses = read_head("time_ns,azimuth_rad,elevation_rad,roll_rad\n0,1.5,0,-0.25\n");
  ASSERT_EQ(poses.size(), 1U);
  EXPECT_EQ(poses[0].heading.azimuth_rad, 1.5);
  EXPECT_EQ(poses[0].roll_rad, -0.25);
  EXPECT_THAT(head_error_of("time_ns,azimuth_rad,elevation_rad,roll_rad\n0,0,0\n"),
              HasSubstr("has 3 fields instead of 4"));
  EXPECT_THAT(head_error_of("time_ns,azimuth_rad,elevation_rad,roll_rad\n0,0,0,3.2\n"),
              HasSubstr("\"3.2\" is not a number from -3.14"));
}

TEST(HeadFile, BringsPosesBackBitForBit) {
  Pcg32 random(3);
  std::vector<HeadPose> poses;
  for (int i = 0; i < 5000; ++i) {
    HeadPose pose{.time = i * Nanoseconds(14'285'714), .heading = {}};
    pose.heading.azimuth_rad = std::numbers::pi * (2.0 * random.uniform() - 1.0);
    pose.heading.elevation_rad = 0.5 * std::numbers::pi * (2.0 * random.uniform() - 1.0);
    poses.push_back(pose);
  }
  std::string content = head_header;
  for (const HeadPose& pose : poses) {
    content += fmt::format("{},{},{}\n", pose.time.count(), pose.heading.azimuth_rad,
                           pose.heading.elevation_rad);
  }
  const auto back = read_head(content);
  ASSERT_EQ(back.size(), poses.size());
  ScriptedHeadTracker replayed = replayed_head(back, std::chrono::hours(5));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    ASSERT_EQ(back[i].time, poses[i].time);
    ASSERT_EQ(back[i].heading.azimuth_rad, poses[i].heading.azimuth_rad);
    ASSERT_EQ(back[i].heading.elevation_rad, poses[i].heading.elevation_rad);
    const HeadPose again = replayed.pose(std::chrono::hours(5) + poses[i].time);
    ASSERT_EQ(again.heading.azimuth_rad, poses[i].heading.azimuth_rad);
    ASSERT_EQ(again.heading.elevation_rad, poses[i].heading.elevation_rad);
  }
}

TEST(HeadFile, ErrorsSayWhere) {
  EXPECT_THAT(head_error_of(""),
              HasSubstr("head.csv:1: is not the first line of a head recording"));
  EXPECT_THAT(head_error_of("time_ns,x,y,z,valid\n"), HasSubstr("head.csv:1: "));
  EXPECT_THAT(head_error_of(head_header), HasSubstr("head.csv: has no samples"));
  // What a line of any recording can have wrong is tested in recordings_test.cpp.
  for (const auto& [line, what] : {std::pair("1,0", "head.csv:3: has 2 fields instead of 3"),
                                   {"1,1001,0", "\"1001\" is not a number from -1000 to 1000"},
                                   {"1,0,1.571", "\"1.571\" is not a number from -1.57"}}) {
    EXPECT_THAT(head_error_of(head_header + "0,0,0\n" + line + "\n"), HasSubstr(what)) << line;
  }
  EXPECT_THROW(read_head_file("/nowhere/head.csv"), Error);
}

TEST(ReplayedHead, BeginsWhenItIsAskedTo) {
  const std::vector<HeadPose> poses{{.time = milliseconds(100), .heading = {.azimuth_rad = 0.5}},
                                    {.time = milliseconds(200), .heading = {.azimuth_rad = 1.0}}};
  ScriptedHeadTracker head = replayed_head(poses, milliseconds(3000));
  EXPECT_EQ(head.pose(milliseconds(3000)).heading.azimuth_rad, 0.5);
  EXPECT_NEAR(head.pose(milliseconds(3150)).heading.azimuth_rad, 0.75, 1e-12);
  EXPECT_EQ(head.pose(milliseconds(3200)).heading.azimuth_rad, 1.0);
  EXPECT_THROW(replayed_head({}, milliseconds(0)), Error);
}

}  // namespace
}  // namespace foveola
