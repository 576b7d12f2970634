#include "study/record/gaze_encoding.h"

#include "renderer/base/files/little_endian.h"
#include "study/record/stored_number.h"

namespace foveola::study {
namespace {

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
