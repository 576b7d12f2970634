#include "renderer/gaze/recordings.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"

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

std::size_t count_fields(std::string_view header) {
  return static_cast<std::size_t>(std::ranges::count(header, ',')) + 1;
}

/// The header in a file's first row. Throws Error if it is not one.
std::string_view header_of(const CsvRow& first, const std::string& file,
                           const RecordingFormat& format) {
  const std::string found = fmt::format("{}", fmt::join(first, ","));
  for (const std::string_view header : {format.header, format.longer_header}) {
    if (!header.empty() && found == header) {
      return header;
    }
  }
  throw Error(file + ":1", fmt::format("is not the first line of a {}", format.name),
              fmt::format("write {}", format.header));
}

constexpr RecordingFormat gaze_format{.name = "gaze recording", .header = "time_ns,x,y,z,valid"};
constexpr std::size_t valid_field = 4;
constexpr float length_tolerance = 1e-3F;

bool is_unit(const Vec3& direction) {
  return std::fabs(glm::length(direction) - 1.0F) <= length_tolerance;
}

/// Unchanged, bit for bit, if its length is 1 within a float's precision.
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
  if (!has_recordable_times(samples) || !std::ranges::all_of(samples, has_good_direction)) {
    throw Error(file.string(), "is not written: such samples cannot be read back",
                "give at least one, times from 0 ascending, and directions of unit length");
  }
}

}  // namespace

RecordedLine::RecordedLine(CsvRow fields, std::string where, std::string_view header)
    : where_(std::move(where)), header_(header), fields_(std::move(fields)) {
  if (const std::size_t expected = count_fields(header_); fields_.size() != expected) {
    fail(fmt::format("has {} fields instead of {}", fields_.size(), expected),
         fmt::format("write {}", header_));
  }
  time_ = Nanoseconds(value(0, std::int64_t{0}, std::int64_t{longest_recording.count()}));
}

template <typename Value>
Value RecordedLine::value(std::size_t number, Value minimum, Value maximum) const {
  const std::string_view text = field(number);
  Value parsed{};
  const char* const end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, parsed);
  if (failure != std::errc() || stop != end || !(parsed >= minimum && parsed <= maximum)) {
    fail(fmt::format("\"{}\" is not a number from {} to {}", text, minimum, maximum),
         fmt::format("the fields are {}", header_));
  }
  return parsed;
}

template float RecordedLine::value(std::size_t, float, float) const;
template double RecordedLine::value(std::size_t, double, double) const;
template std::int64_t RecordedLine::value(std::size_t, std::int64_t, std::int64_t) const;

void RecordedLine::fail(const std::string& what, const std::string& remedy) const {
  throw Error(where_, what, remedy);
}

void read_recording(const std::filesystem::path& file, const RecordingFormat& format,
                    const std::function<void(const RecordedLine&)>& take) {
  std::vector<CsvRow> rows = parse_csv(read_file(file), file.string());
  const std::string_view header =
      header_of(rows.empty() ? CsvRow() : rows.front(), file.string(), format);
  std::optional<Nanoseconds> last_time;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const RecordedLine line(std::move(rows[i]), fmt::format("{}:{}", file.string(), i + 1), header);
    if (last_time && line.time() <= *last_time) {
      line.fail("is not later than the line before", "put the lines in the order of time");
    }
    take(line);
    last_time = line.time();
  }
  if (!last_time) {
    throw Error(file.string(), "has no samples", "record some");
  }
}

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
