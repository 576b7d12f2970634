// Files of what a display shows, written in the background.
#pragma once

#include <filesystem>
#include <future>
#include <string>
#include <utility>
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

  /// What became of a picture of write_next().
  struct Written {
    std::filesystem::path file;
    std::string fault;  ///< empty: it is there
  };
  /// Those of write_next() that are finished and that no call returned before.
  std::vector<Written> take_written();

  /// Waits for all others; rethrows what kept the first one from being written.
  void finish();

 private:
  int last_number_ = 0;
  // std::async's, which wait when they go.
  std::vector<std::future<void>> private_ones_;
  std::vector<std::pair<std::filesystem::path, std::future<void>>> numbered_ones_;
};

}  // namespace foveola
