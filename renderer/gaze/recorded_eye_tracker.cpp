#include "renderer/gaze/recorded_eye_tracker.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/gaze/recording_file.h"

namespace foveola {
namespace {

constexpr RecordingFormat gaze_format{.name = "gaze recording", .header = "time_ns,x,y,z,valid"};
constexpr std::size_t valid_field = 4;
constexpr float length_tolerance = 1e-3F;

bool is_unit(const Vec3& direction) {
  return std::fabs(glm::length(direction) - 1.0F) <= length_tolerance;
}

/// Left alone, bit for bit, if its length is 1 as exactly as floats can say.
Vec3 unit(const Vec3& direction) {
  constexpr float rounding = 1e-6F;
  return std::fabs(glm::length(direction) - 1.0F) <= rounding ? direction
                                                              : glm::normalize(direction);
}

Vec3 recorded_direction(const RecordedLine& line) {
  Vec3 direction;
  for (int axis = 0; axis < 3; ++axis) {
    direction[axis] = line.value(static_cast<std::size_t>(axis) + 1, -2.0F, 2.0F);
  }
  if (!is_unit(direction)) {
    line.fail(fmt::format("the direction has length {}", glm::length(direction)),
              "give it length 1");
  }
  return unit(direction);
}

GazeSample sample_from(const RecordedLine& line) {
  const std::string_view valid = line.field(valid_field);
  GazeSample sample{.time = line.time(), .valid = valid == "1"};
  if (sample.valid) {
    sample.direction = recorded_direction(line);
  } else if (valid != "0") {
    line.fail(fmt::format("valid is \"{}\"", valid), "write 1 or 0");
  } else if (!line.field(1).empty() || !line.field(2).empty() || !line.field(3).empty()) {
    line.fail("an invalid sample has a direction", "leave x, y and z empty");
  }
  return sample;
}

void require_writable_samples(const std::filesystem::path& file,
                              std::span<const GazeSample> samples) {
  const auto has_good_direction = [](const GazeSample& sample) {
    return !sample.valid || is_unit(sample.direction);
  };
  if (!has_recordable_times(samples) ||
      !std::all_of(samples.begin(), samples.end(), has_good_direction)) {
    throw Error(file.string(), "is not written: such samples cannot be read back",
                "give at least one, times from 0 ascending, and directions of unit length");
  }
}

}  // namespace

std::vector<GazeSample> read_gaze_file(const std::filesystem::path& file) {
  std::vector<GazeSample> samples;
  read_recording(file, gaze_format,
                 [&](const RecordedLine& line) { samples.push_back(sample_from(line)); });
  return samples;
}

void write_gaze_file(const std::filesystem::path& file, std::span<const GazeSample> samples) {
  require_writable_samples(file, samples);
  std::string text = fmt::format("{}\n", gaze_format.header);
  for (const GazeSample& sample : samples) {
    const Vec3& d = sample.direction;
    if (sample.valid) {
      fmt::format_to(std::back_inserter(text), "{},{},{},{},1\n", sample.time.count(), d.x, d.y,
                     d.z);
    } else {
      fmt::format_to(std::back_inserter(text), "{},,,,0\n", sample.time.count());
    }
  }
  write_file(file, text, FileAccess::own);
}

std::vector<GazeSample> replayable(std::span<const GazeSample> arrived) {
  std::vector<GazeSample> samples;
  for (const GazeSample& sample : arrived) {
    const Nanoseconds time = sample.time - arrived.front().time;
    if (samples.empty() || time > samples.back().time) {
      samples.push_back(sample);
      samples.back().time = time;
    }
  }
  return samples;
}

RecordedEyeTracker::RecordedEyeTracker(std::vector<GazeSample> samples, Nanoseconds start,
                                       Nanoseconds latency)
    : samples_(std::move(samples)), start_(start), latency_(latency) {
  if (!times_ascend(std::span<const GazeSample>(samples_))) {
    throw Error("recorded gaze", "its times do not ascend", "put the samples in order");
  }
}

void RecordedEyeTracker::poll(Nanoseconds now, std::vector<GazeSample>& arrived) {
  const Nanoseconds seen = now - start_ - latency_;
  for (; next_ < samples_.size() && samples_[next_].time <= seen; ++next_) {
    arrived.push_back(samples_[next_]);
    arrived.back().time += start_;
  }
}

}  // namespace foveola
