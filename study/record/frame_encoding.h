// Frames as the bytes that the record keeps of them.
#pragma once

#include <string>
#include <vector>

#include "study/record/study_store.h"

namespace foveola::study {

/// The name by which the record calls encode_frames' format.
constexpr const char* frame_encoding_name = "frames-2";

/// The frames in the format that schema.sql describes at frame_chunk: 44 bytes each,
/// little-endian.
std::string encode_frames(const std::vector<FrameRow>& frames);

}  // namespace foveola::study
