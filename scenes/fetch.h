// Putting a real scene's file where Foveola finds it.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>

#include "scenes/descriptor.h"

namespace foveola::scenes {

/// Downloads the descriptor's file into fetched_folder(), or a user's own descriptor's into the
/// descriptor's folder, unless it is there, and returns its path. An interrupted download is
/// continued, by one program at a time; others wait. Nothing takes the file's name before its size
/// and SHA-256 are right. Throws Error if the descriptor has no address, and for whatever goes
/// wrong.
std::filesystem::path fetch_from_web(const Descriptor& descriptor,
                                     const std::function<void(double fraction)>& progress,
                                     const std::stop_token& stop);

/// What fetch_from_disk takes.
enum class Accept {
  described_file,  ///< nothing but the file that the descriptor was written for
  any_glb,         ///< a person's own conversion too, in its place and under its name
};

/// Copies the descriptor's file to where fetch_from_web puts it from a file, or from a folder that
/// holds one of that name, there or one folder below.
std::filesystem::path fetch_from_disk(const Descriptor& descriptor,
                                      const std::filesystem::path& file_or_folder, Accept accept);

}  // namespace foveola::scenes
