#include "renderer/gaze/recorded_eye_tracker.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace foveola {
namespace {

constexpr std::string_view header = "time_ns,x,y,z,valid";
constexpr std::size_t field_count = 5;
constexpr std::int64_t largest_time_ns = 1'000'000'000'000'000'000;
constexpr float length_tolerance = 1e-3F;

using Fields = std::array<std::string_view, field_count>;

/// Takes the first line, without its end, off the front of `text`.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) {
    line.remove_suffix(1);
  }
  return line;
}

Fields fields_of(std::string_view line, const std::string& where) {
  const auto commas = static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
  if (commas + 1 != field_count) {
    throw Error(where, fmt::format("has {} fields instead of {}", commas + 1, field_count),
                fmt::format("write {}", header));
  }
  Fields fields;
  for (std::string_view& field : fields) {
    const std::size_t end = std::min(line.find(','), line.size());
    field = line.substr(0, end);
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return fields;
}

template <typename Number>
Number number(std::string_view field, Number minimum, Number maximum, const std::string& where) {
  Number value{};
  const char* const end = field.data() + field.size();
  const auto [stop, failure] = std::from_chars(field.data(), end, value);
  if (failure != std::errc() || stop != end || !(value >= minimum && value <= maximum)) {
    throw Error(where, fmt::format("\"{}\" is no number from {} to {}", field, minimum, maximum),
                fmt::format("the fields are {}", header));
  }
  return value;
}

bool is_unit(const Vec3& direction) {
  return std::fabs(glm::length(direction) - 1.0F) <= length_tolerance;
}

/// Left alone, bit for bit, if its length is 1 as exactly as floats can say.
Vec3 unit(const Vec3& direction) {
  constexpr float rounding = 1e-6F;
  return std::fabs(glm::length(direction) - 1.0F) <= rounding ? direction
                                                              : glm::normalize(direction);
}

Vec3 direction_from_fields(const Fields& fields, const std::string& where) {
  Vec3 direction;
  for (int axis = 0; axis < 3; ++axis) {
    direction[axis] = number(fields[static_cast<std::size_t>(axis) + 1], -2.0F, 2.0F, where);
  }
  if (!is_unit(direction)) {
    throw Error(where, fmt::format("the direction has length {}", glm::length(direction)),
                "give it length 1");
  }
  return unit(direction);
}

GazeSample sample_from(const Fields& fields, const std::string& where) {
  const std::string_view valid = fields.back();
  GazeSample sample{
      .time = Nanoseconds(number(fields.front(), std::int64_t{0}, largest_time_ns, where)),
      .valid = valid == "1"};
  if (sample.valid) {
    sample.direction = direction_from_fields(fields, where);
  } else if (valid != "0") {
    throw Error(where, fmt::format("valid is \"{}\"", valid), "write 1 or 0");
  } else if (!fields[1].empty() || !fields[2].empty() || !fields[3].empty()) {
    throw Error(where, "an invalid sample has a direction", "leave x, y and z empty");
  }
  return sample;
}

const auto is_not_earlier = [](const GazeSample& a, const GazeSample& b) {
  return a.time >= b.time;
};

bool times_ascend(std::span<const GazeSample> samples) {
  return std::adjacent_find(samples.begin(), samples.end(), is_not_earlier) == samples.end();
}

void require_writable_samples(const std::filesystem::path& file,
                              std::span<const GazeSample> samples) {
  const auto is_good = [](const GazeSample& sample) {
    return sample.time.count() >= 0 && sample.time.count() <= largest_time_ns &&
           (!sample.valid || is_unit(sample.direction));
  };
  if (samples.empty() || !times_ascend(samples) ||
      !std::all_of(samples.begin(), samples.end(), is_good)) {
    throw Error(file.string(), "is not written: such samples cannot be read back",
                "give at least one, times from 0 ascending, and directions of unit length");
  }
}

}  // namespace

std::vector<GazeSample> read_gaze_file(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  std::string_view rest = text;
  if (take_line(rest) != header) {
    throw Error(file.string() + ":1", "is not the first line of a gaze recording",
                fmt::format("write {}", header));
  }
  std::vector<GazeSample> samples;
  for (int line = 2; !rest.empty(); ++line) {
    const std::string where = fmt::format("{}:{}", file.string(), line);
    samples.push_back(sample_from(fields_of(take_line(rest), where), where));
    if (!times_ascend(std::span(samples).last(std::min<std::size_t>(samples.size(), 2)))) {
      throw Error(where, "is not later than the line before", "put the samples in order");
    }
  }
  if (samples.empty()) {
    throw Error(file.string(), "has no samples", "record some");
  }
  return samples;
}

void write_gaze_file(const std::filesystem::path& file, std::span<const GazeSample> samples) {
  require_writable_samples(file, samples);
  std::string text = fmt::format("{}\n", header);
  for (const GazeSample& sample : samples) {
    const Vec3& d = sample.direction;
    if (sample.valid) {
      fmt::format_to(std::back_inserter(text), "{},{},{},{},1\n", sample.time.count(), d.x, d.y,
                     d.z);
    } else {
      fmt::format_to(std::back_inserter(text), "{},,,,0\n", sample.time.count());
    }
  }
  write_file(file, text);
}

RecordedEyeTracker::RecordedEyeTracker(std::vector<GazeSample> samples, Nanoseconds start,
                                       Nanoseconds latency)
    : samples_(std::move(samples)), start_(start), latency_(latency) {
  if (!times_ascend(samples_)) {
    throw Error("recorded gaze", "its times do not ascend", "put the samples in order");
  }
}

std::optional<GazeSample> RecordedEyeTracker::newest(Nanoseconds now) {
  const Nanoseconds seen = now - start_ - latency_;
  const auto next = std::partition_point(samples_.begin(), samples_.end(),
                                         [&](const GazeSample& s) { return s.time <= seen; });
  if (next == samples_.begin()) {
    return std::nullopt;
  }
  GazeSample sample = *std::prev(next);
  sample.time += start_;
  return sample;
}

}  // namespace foveola
