// Gaze samples as the bytes that the record keeps of them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/gaze/eye_tracker.h"

namespace foveola::study {

/// The name by which the record calls encode_gaze's format.
constexpr const char* gaze_encoding_name = "gaze-1";

constexpr std::int64_t bytes_per_gaze_sample = 24;

/// The samples in the format that schema.sql describes at gaze_chunk: 24 bytes each, little-endian.
std::string encode_gaze(const std::vector<GazeSample>& samples);

/// The samples that were encoded. What is behind the last whole one is left out.
std::vector<GazeSample> decode_gaze(std::string_view bytes);

}  // namespace foveola::study
