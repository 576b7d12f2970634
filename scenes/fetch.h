// Fetches a real scene's file to the place where Foveola finds it.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>

#include "scenes/descriptor.h"

namespace foveola::scenes {

/// Downloads the descriptor's file into fetched_folder(), or a user's own descriptor's into the
/// descriptor's folder, unless it exists. Returns its path. An interrupted download is continued,
/// by one program at a time; others wait. The file gets its name only once its size and SHA-256 are
/// right. Throws Error if the descriptor has no address, or if a step fails.
std::filesystem::path fetch_from_web(const Descriptor& descriptor,
                                     const std::function<void(double fraction)>& progress,
                                     const std::stop_token& stop);

/// Files that fetch_from_disk accepts.
enum class Accept {
  described_file,  ///< only the file that the descriptor was written for
  any_glb,         ///< also a user's conversion, in its place and under its name
};

/// Copies the descriptor's file to the place of fetch_from_web, from a file, or from a folder with
/// a file of that name, in it or one folder below.
std::filesystem::path fetch_from_disk(const Descriptor& descriptor,
                                      const std::filesystem::path& file_or_folder, Accept accept);

}  // namespace foveola::scenes
