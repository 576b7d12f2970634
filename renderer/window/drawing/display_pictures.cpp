#include "renderer/window/drawing/display_pictures.h"

#include <chrono>
#include <exception>

#include <fmt/format.h>

#include "renderer/base/files/files.h"
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

namespace {

std::future<void> write_later(const std::filesystem::path& file, std::future<RgbImage> picture,
                              void (*write)(const std::filesystem::path&, const RgbImage&)) {
  return std::async(std::launch::async, [file, write, picture = std::move(picture)]() mutable {
    write(file, picture.get());
  });
}

}  // namespace

void DisplayPictures::write_privately(const std::filesystem::path& file,
                                      std::future<RgbImage> picture) {
  const auto write = [](const std::filesystem::path& path, const RgbImage& shown) {
    replace_file(
        path,
        [&](const std::filesystem::path& temporary) { write_display_picture(temporary, shown); },
        FileAccess::own);
  };
  private_ones_.push_back(write_later(file, std::move(picture), write));
}

std::filesystem::path DisplayPictures::write_next(std::future<RgbImage> picture) {
  const auto file = [this] {
    return std::filesystem::path(fmt::format("foveola-{}.png", last_number_));
  };
  // A picture taken a moment ago may not be on the disk yet.
  do {
    ++last_number_;
  } while (std::filesystem::exists(file()));
  numbered_ones_.emplace_back(file(),
                              write_later(file(), std::move(picture), write_display_picture));
  return file();
}

std::vector<DisplayPictures::Written> DisplayPictures::take_written() {
  std::vector<Written> written;
  std::erase_if(numbered_ones_, [&](auto& one) {
    if (one.second.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      return false;
    }
    written.push_back({.file = one.first, .fault = {}});
    try {
      one.second.get();
    } catch (const std::exception& fault) {
      written.back().fault = fault.what();
    }
    return true;
  });
  return written;
}

void DisplayPictures::finish() {
  std::vector<std::future<void>> pictures = std::exchange(private_ones_, {});
  for (auto& [file, picture] : std::exchange(numbered_ones_, {})) {
    pictures.push_back(std::move(picture));
  }
  for (std::future<void>& written : pictures) {
    written.get();
  }
}

}  // namespace foveola
