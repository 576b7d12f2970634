#include "study/record/frame_encoding.h"

#include <bit>
#include <climits>
#include <concepts>

namespace foveola::study {
namespace {

constexpr std::size_t frame_bytes = 44;

void append(std::string& bytes, std::unsigned_integral auto value) {
  for (std::size_t i = 0; i < sizeof value; ++i) {
    bytes.push_back(static_cast<char>((value >> (i * CHAR_BIT)) & 0xFFU));
  }
}

void append(std::string& bytes, float value) { append(bytes, std::bit_cast<std::uint32_t>(value)); }

void append(std::string& bytes, Nanoseconds value) {
  append(bytes, static_cast<std::uint64_t>(value.count()));
}

void append(std::string& bytes, const FrameRow& frame) {
  append(bytes, frame.time);
  append(bytes, frame.head_azimuth_rad);
  append(bytes, frame.head_elevation_rad);
  append(bytes, frame.gaze.x);
  append(bytes, frame.gaze.y);
  append(bytes, frame.gaze.z);
  append(bytes, frame.gaze_age);
  append(bytes, frame.samples);
  append(bytes, (frame.gaze_valid ? 1U : 0U) | (frame.gaze_held ? 2U : 0U));
}

}  // namespace

std::string encode_frames(const std::vector<FrameRow>& frames) {
  std::string bytes;
  bytes.reserve(frames.size() * frame_bytes);
  for (const FrameRow& frame : frames) {
    append(bytes, frame);
  }
  return bytes;
}

}  // namespace foveola::study
