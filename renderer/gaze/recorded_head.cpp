#include "renderer/gaze/recorded_head.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/gaze/recording_file.h"

namespace foveola {
namespace {

constexpr RecordingFormat head_format{.name = "head recording",
                                      .header = "time_ns,azimuth_rad,elevation_rad"};
constexpr double largest_azimuth_rad = 1000.0;
constexpr double largest_elevation_rad = 0.5 * std::numbers::pi;

HeadPose pose_from(const RecordedLine& line) {
  HeadPose pose{.time = line.time(), .heading = {}};
  pose.heading.azimuth_rad = line.value(1, -largest_azimuth_rad, largest_azimuth_rad);
  pose.heading.elevation_rad = line.value(2, -largest_elevation_rad, largest_elevation_rad);
  return pose;
}

bool has_recordable_heading(const HeadPose& pose) {
  return std::abs(pose.heading.azimuth_rad) <= largest_azimuth_rad &&
         std::abs(pose.heading.elevation_rad) <= largest_elevation_rad;
}

}  // namespace

std::vector<HeadPose> read_head_file(const std::filesystem::path& file) {
  std::vector<HeadPose> poses;
  read_recording(file, head_format,
                 [&](const RecordedLine& line) { poses.push_back(pose_from(line)); });
  return poses;
}

void write_head_file(const std::filesystem::path& file, std::span<const HeadPose> poses) {
  if (!has_recordable_times(poses) ||
      !std::all_of(poses.begin(), poses.end(), has_recordable_heading)) {
    throw Error(file.string(), "is not written: such poses cannot be read back",
                "give at least one, times from 0 ascending, and headings in their ranges");
  }
  std::string text = fmt::format("{}\n", head_format.header);
  for (const HeadPose& pose : poses) {
    fmt::format_to(std::back_inserter(text), "{},{},{}\n", pose.time.count(),
                   pose.heading.azimuth_rad, pose.heading.elevation_rad);
  }
  write_file(file, text);
}

ScriptedHeadTracker replayed_head(std::vector<HeadPose> poses, Nanoseconds start) {
  for (HeadPose& pose : poses) {
    pose.time += start;
  }
  return ScriptedHeadTracker(std::move(poses));
}

}  // namespace foveola
