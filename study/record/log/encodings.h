// Frames and gaze samples as the bytes that the record keeps of them, and back.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/gaze/eye_tracker.h"
#include "study/record/write/study_store.h"

namespace foveola::study {

/// The name by which the record calls encode_frames' format.
constexpr const char* frame_encoding_name = "frames-3";

/// How many bytes a frame takes in a format of the record: "frames-2" or "frames-3".
std::int64_t bytes_per_frame(const std::string& encoding);

/// The frames in the format that schema.sql describes at frame_chunk: 52 bytes each,
/// little-endian.
std::string encode_frames(const std::vector<FrameRow>& frames);

/// The frames that were encoded. Those of "frames-2" did not say when they were on the display, nor
/// whether they were late: `presented` is then `time`. What is behind the last whole one is left
/// out.
std::vector<FrameRow> decode_frames(const std::string& encoding, std::string_view bytes);

/// The name by which the record calls encode_gaze's format.
constexpr const char* gaze_encoding_name = "gaze-1";

constexpr std::int64_t bytes_per_gaze_sample = 24;

/// The samples in the format that schema.sql describes at gaze_chunk: 24 bytes each, little-endian.
std::string encode_gaze(const std::vector<GazeSample>& samples);

/// The samples that were encoded. What is behind the last whole one is left out.
std::vector<GazeSample> decode_gaze(std::string_view bytes);

}  // namespace foveola::study
