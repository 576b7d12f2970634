#include "study/record/log/encodings.h"

#include <cmath>
#include <numbers>

#include "renderer/base/files/little_endian.h"
#include "study/record/sqlite/stored_number.h"

namespace foveola::study {
namespace {

constexpr const char* encoding_without_presentation = "frames-2";
constexpr std::uint32_t gaze_valid_bit = 1;
constexpr std::uint32_t gaze_held_bit = 2;
constexpr std::uint32_t late_bit = 4;
constexpr std::uint32_t roll_shift = 16;
constexpr double roll_step_rad = 2.0 * std::numbers::pi / 65536.0;

bool keeps_presentation(const std::string& encoding) {
  return encoding != encoding_without_presentation;
}

/// In 16 bits, as the complement of two.
std::uint32_t roll_steps(const FrameRow& frame) {
  return static_cast<std::uint16_t>(std::lround(frame.head_roll_rad / roll_step_rad));
}

std::uint32_t flags_of(const FrameRow& frame) {
  return (frame.gaze_valid ? gaze_valid_bit : 0U) | (frame.gaze_held ? gaze_held_bit : 0U) |
         (frame.is_late ? late_bit : 0U) | (roll_steps(frame) << roll_shift);
}

void append_frame(std::string& bytes, const FrameRow& frame) {
  append(bytes, frame.time);
  append(bytes, frame.presented);
  append(bytes, frame.head_azimuth_rad);
  append(bytes, frame.head_elevation_rad);
  append(bytes, frame.gaze);
  append(bytes, frame.gaze_age);
  append(bytes, frame.samples);
  append(bytes, flags_of(frame));
}

Nanoseconds take_time(std::string_view& bytes) {
  return time_from(take_nanoseconds(bytes).count());
}

FrameRow take_frame(std::string_view& bytes, bool keeps_presentation) {
  FrameRow frame;
  frame.time = take_time(bytes);
  frame.presented = keeps_presentation ? take_time(bytes) : frame.time;
  frame.head_azimuth_rad = take_float(bytes);
  frame.head_elevation_rad = take_float(bytes);
  for (int axis = 0; axis < 3; ++axis) {
    frame.gaze[axis] = take_float(bytes);
  }
  frame.gaze_age = take_time(bytes);
  frame.samples = take<std::uint32_t>(bytes);
  const auto flags = take<std::uint32_t>(bytes);
  frame.gaze_valid = (flags & gaze_valid_bit) != 0;
  frame.gaze_held = (flags & gaze_held_bit) != 0;
  frame.is_late = (flags & late_bit) != 0;
  const auto steps = static_cast<std::int16_t>(flags >> roll_shift);
  frame.head_roll_rad = static_cast<float>(roll_step_rad * steps);
  return frame;
}

constexpr std::uint32_t valid_bit = 1;
constexpr std::uint32_t mark_shift = 1;
constexpr std::uint32_t mark_mask = 3;
constexpr std::uint32_t time_unknown_bit = 8;

void append_sample(std::string& bytes, const GazeSample& sample) {
  append(bytes, sample.time);
  append(bytes, sample.direction);
  append(bytes, (sample.valid ? valid_bit : 0U) |
                    (static_cast<std::uint32_t>(sample.mark) << mark_shift) |
                    (sample.is_time_known ? 0U : time_unknown_bit));
}

GazeSample take_sample(std::string_view& bytes) {
  GazeSample sample{.time = time_from(take_nanoseconds(bytes).count())};
  for (int axis = 0; axis < 3; ++axis) {
    sample.direction[axis] = take_float(bytes);
  }
  const auto flags = take<std::uint32_t>(bytes);
  sample.valid = (flags & valid_bit) != 0;
  sample.mark = static_cast<GazeMark>((flags >> mark_shift) & mark_mask);
  sample.is_time_known = (flags & time_unknown_bit) == 0;
  return sample;
}

}  // namespace

std::int64_t bytes_per_frame(const std::string& encoding) {
  return keeps_presentation(encoding) ? 52 : 44;
}

std::string encode_frames(const std::vector<FrameRow>& frames) {
  std::string bytes;
  bytes.reserve(frames.size() * bytes_per_frame(frame_encoding_name));
  for (const FrameRow& frame : frames) {
    append_frame(bytes, frame);
  }
  return bytes;
}

std::vector<FrameRow> decode_frames(const std::string& encoding, std::string_view bytes) {
  std::vector<FrameRow> frames;
  while (std::ssize(bytes) >= bytes_per_frame(encoding)) {
    frames.push_back(take_frame(bytes, keeps_presentation(encoding)));
  }
  return frames;
}

std::string encode_gaze(const std::vector<GazeSample>& samples) {
  std::string bytes;
  bytes.reserve(samples.size() * bytes_per_gaze_sample);
  for (const GazeSample& sample : samples) {
    append_sample(bytes, sample);
  }
  return bytes;
}

std::vector<GazeSample> decode_gaze(std::string_view bytes) {
  std::vector<GazeSample> samples;
  while (std::ssize(bytes) >= bytes_per_gaze_sample) {
    samples.push_back(take_sample(bytes));
  }
  return samples;
}

}  // namespace foveola::study
