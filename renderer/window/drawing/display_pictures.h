// Writes files of the display's pictures in the background.
#pragma once

#include <filesystem>
#include <future>
#include <string>
#include <utility>
#include <vector>

#include "renderer/image/image.h"

namespace foveola {

/// Writes a display's picture, sRGB in [0, 1], as write_image does with linear radiance.
void write_display_picture(const std::filesystem::path& file, const RgbImage& picture);

/// Its destructor waits for all writing.
class DisplayPictures {
 public:
  /// Writes the picture to this file once it is ready; a private one, of a page that a person saw.
  void write_privately(const std::filesystem::path& file, std::future<RgbImage> picture);

  /// Writes the picture to the first of foveola-1.png, foveola-2.png, and so on that does not exist
  /// yet. Returns its path.
  std::filesystem::path write_next(std::future<RgbImage> picture);

  /// The result of a write_next().
  struct Written {
    std::filesystem::path file;
    std::string fault;  ///< empty: success
  };
  /// The results of write_next() that are new since the last call.
  std::vector<Written> take_written();

  /// Waits for all others; rethrows the first fault.
  void finish();

 private:
  int last_number_ = 0;
  // Futures of std::async, whose destructors wait.
  std::vector<std::future<void>> private_ones_;
  std::vector<std::pair<std::filesystem::path, std::future<void>>> numbered_ones_;
};

}  // namespace foveola
