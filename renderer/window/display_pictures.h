// Files of what a display shows, written in the background.
#pragma once

#include <filesystem>
#include <future>
#include <vector>

#include "renderer/image/image.h"

namespace foveola {

/// Writes what a display shows, sRGB in [0, 1], as write_image does with linear radiance.
void write_display_picture(const std::filesystem::path& file, const RgbImage& picture);

/// Its destructor waits until all are written.
class DisplayPictures {
 public:
  /// The picture becomes this file as soon as it is there; a private one, of a page that a person
  /// saw.
  void write_privately(const std::filesystem::path& file, std::future<RgbImage> picture);

  /// The picture becomes the next of foveola-1.png, foveola-2.png, and so on that is not there yet.
  /// Returns which.
  std::filesystem::path write_next(std::future<RgbImage> picture);

  /// Waits for all; rethrows what kept the first one from being written.
  void finish();

 private:
  void write(const std::filesystem::path& file, std::future<RgbImage> picture,
             void (*write_picture)(const std::filesystem::path&, const RgbImage&));

  int last_number_ = 0;
  std::vector<std::future<void>> being_written_;  ///< std::async's: they wait when they go
};

}  // namespace foveola
