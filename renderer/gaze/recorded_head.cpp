#include "renderer/gaze/recorded_head.h"

#include <numbers>
#include <utility>

#include "renderer/gaze/recording_file.h"

namespace foveola {
namespace {

constexpr RecordingFormat head_format{
    .name = "head recording",
    .header = "time_ns,azimuth_rad,elevation_rad",
    .longer_header = "time_ns,azimuth_rad,elevation_rad,roll_rad"};
constexpr double largest_azimuth_rad = 1000.0;
constexpr double largest_elevation_rad = 0.5 * std::numbers::pi;

HeadPose pose_from(const RecordedLine& line) {
  HeadPose pose{.time = line.time(), .heading = {}};
  pose.heading.azimuth_rad = line.value(1, -largest_azimuth_rad, largest_azimuth_rad);
  pose.heading.elevation_rad = line.value(2, -largest_elevation_rad, largest_elevation_rad);
  if (line.field_count() > 3) {
    pose.roll_rad = line.value(3, -std::numbers::pi, std::numbers::pi);
  }
  return pose;
}

}  // namespace

std::vector<HeadPose> read_head_file(const std::filesystem::path& file) {
  std::vector<HeadPose> poses;
  read_recording(file, head_format,
                 [&](const RecordedLine& line) { poses.push_back(pose_from(line)); });
  return poses;
}

ScriptedHeadTracker replayed_head(std::vector<HeadPose> poses, Nanoseconds start) {
  for (HeadPose& pose : poses) {
    pose.time += start;
  }
  return ScriptedHeadTracker(std::move(poses));
}

}  // namespace foveola
