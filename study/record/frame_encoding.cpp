#include "study/record/frame_encoding.h"

#include "study/record/little_endian.h"

namespace foveola::study {
namespace {

constexpr std::size_t frame_bytes = 44;

void append_frame(std::string& bytes, const FrameRow& frame) {
  append(bytes, frame.time);
  append(bytes, frame.head_azimuth_rad);
  append(bytes, frame.head_elevation_rad);
  append(bytes, frame.gaze);
  append(bytes, frame.gaze_age);
  append(bytes, frame.samples);
  append(bytes, (frame.gaze_valid ? 1U : 0U) | (frame.gaze_held ? 2U : 0U));
}

}  // namespace

std::string encode_frames(const std::vector<FrameRow>& frames) {
  std::string bytes;
  bytes.reserve(frames.size() * frame_bytes);
  for (const FrameRow& frame : frames) {
    append_frame(bytes, frame);
  }
  return bytes;
}

}  // namespace foveola::study
