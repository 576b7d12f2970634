#include "renderer/window/display_pictures.h"

#include <utility>

#include <fmt/format.h>

#include "renderer/base/files.h"
#include "renderer/image/image_file.h"
#include "renderer/image/tone_mapping.h"

namespace foveola {

void write_display_picture(const std::filesystem::path& file, const RgbImage& picture) {
  RgbImage linear = picture;
  for (Rgb& color : linear.pixels) {
    color = Rgb(linear_from_srgb(color.r), linear_from_srgb(color.g), linear_from_srgb(color.b));
  }
  write_image(file, linear, 0.0);
}

void DisplayPictures::write(const std::filesystem::path& file, std::future<RgbImage> picture,
                            void (*write_picture)(const std::filesystem::path&, const RgbImage&)) {
  being_written_.push_back(
      std::async(std::launch::async, [file, write_picture, picture = std::move(picture)]() mutable {
        write_picture(file, picture.get());
      }));
}

void DisplayPictures::write_privately(const std::filesystem::path& file,
                                      std::future<RgbImage> picture) {
  write(file, std::move(picture), [](const std::filesystem::path& path, const RgbImage& shown) {
    replace_file(
        path,
        [&](const std::filesystem::path& temporary) { write_display_picture(temporary, shown); },
        FileAccess::own);
  });
}

std::filesystem::path DisplayPictures::write_next(std::future<RgbImage> picture) {
  const auto file = [this] {
    return std::filesystem::path(fmt::format("foveola-{}.png", last_number_));
  };
  // One that was taken a moment ago may not be on the disk yet.
  do {
    ++last_number_;
  } while (std::filesystem::exists(file()));
  write(file(), std::move(picture), write_display_picture);
  return file();
}

void DisplayPictures::finish() {
  std::vector<std::future<void>> pictures = std::exchange(being_written_, {});
  for (std::future<void>& written : pictures) {
    written.get();
  }
}

}  // namespace foveola
