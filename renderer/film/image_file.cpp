#include "renderer/film/image_file.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/film/tone_mapping.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

constexpr int largest_side = 65536;

std::string lower_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// Writes `pixels` (spec.nchannels values each) in one step.
void write_pixels(const fs::path& path, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                  const void* pixels) {
  replace_file(path, [&](const fs::path& temporary) {
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(temporary.string());
    if (!output) {
      throw Error(path.string(), "cannot be written: " + OIIO::geterror());
    }
    if (!output->open(temporary.string(), spec) || !output->write_image(type, pixels) ||
        !output->close()) {
      throw Error(path.string(), "cannot be written: " + output->geterror(),
                  "check the free space and permissions");
    }
  });
}

void write_exr(const fs::path& path, const RgbImage& image,
               const std::vector<std::uint32_t>* samples) {
  const int channels = samples != nullptr ? 4 : 3;
  OIIO::ImageSpec spec(image.width, image.height, channels, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"R", "G", "B"};
  std::vector<float> values;
  values.reserve(image.pixels.size() * static_cast<std::size_t>(channels));
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    values.insert(values.end(), {image.pixels[i].r, image.pixels[i].g, image.pixels[i].b});
    if (samples != nullptr) {
      values.push_back(static_cast<float>((*samples)[i]));
    }
  }
  if (samples != nullptr) {
    spec.channelnames.emplace_back("samples");
  }
  write_pixels(path, spec, OIIO::TypeDesc::FLOAT, values.data());
}

void write_png(const fs::path& path, const RgbImage& linear, double exposure_stops) {
  const RgbImage display = display_image(linear, exposure_stops);
  OIIO::ImageSpec spec(display.width, display.height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  std::vector<std::uint8_t> values;
  values.reserve(display.pixels.size() * 3);
  for (const Rgb& pixel : display.pixels) {
    for (int channel = 0; channel < 3; ++channel) {
      values.push_back(static_cast<std::uint8_t>(std::lround(pixel[channel] * 255.0F)));
    }
  }
  write_pixels(path, spec, OIIO::TypeDesc::UINT8, values.data());
}

void write(const fs::path& path, const RgbImage& image, const std::vector<std::uint32_t>* samples,
           double exposure_stops) {
  require_image_extension(path);
  if (lower_extension(path) == ".exr") {
    write_exr(path, image, samples);
  } else {
    write_png(path, image, exposure_stops);
  }
}

/// The position of the channel `name`, or `fallback`.
int channel_index(const OIIO::ImageSpec& spec, const std::string& name, int fallback) {
  const int found = spec.channelindex(name);
  return found >= 0 ? found : fallback;
}

FilmImage film_image_from(const OIIO::ImageSpec& spec, const std::vector<float>& values) {
  const int samples_channel = spec.channelindex("samples");
  const bool encoded = spec.format.basetype == OIIO::TypeDesc::UINT8;
  const int grey = spec.nchannels < 3 ? 0 : -1;
  const int channels[3] = {channel_index(spec, "R", 0), grey == 0 ? 0 : channel_index(spec, "G", 1),
                           grey == 0 ? 0 : channel_index(spec, "B", 2)};
  FilmImage image{.color = RgbImage(spec.width, spec.height), .samples = {}};
  image.samples.assign(image.color.pixels.size(), 1);
  for (std::size_t i = 0; i < image.color.pixels.size(); ++i) {
    const float* pixel = &values[i * static_cast<std::size_t>(spec.nchannels)];
    for (int channel = 0; channel < 3; ++channel) {
      const float value = pixel[channels[channel]];
      image.color.pixels[i][channel] = encoded ? linear_from_srgb(value) : value;
    }
    if (samples_channel >= 0) {
      image.samples[i] = static_cast<std::uint32_t>(std::max(0.0F, pixel[samples_channel]));
    }
  }
  return image;
}

}  // namespace

void require_image_extension(const fs::path& path) {
  const std::string extension = lower_extension(path);
  if (extension != ".exr" && extension != ".png") {
    throw UsageError(path.string(),
                     fmt::format("'{}' is no image format to write", path.extension().string()),
                     "use .exr or .png");
  }
}

void write_film_image(const fs::path& path, const FilmImage& image, double exposure_stops) {
  write(path, image.color, &image.samples, exposure_stops);
}

void write_image(const fs::path& path, const RgbImage& image, double exposure_stops) {
  write(path, image, nullptr, exposure_stops);
}

FilmImage read_film_image(const fs::path& path) {
  if (!fs::is_regular_file(path)) {
    throw Error(path.string(), fs::exists(path) ? "is no file" : "no such file", "check the path");
  }
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string());
  if (!input) {
    throw Error(path.string(), "cannot be read as an image: " + OIIO::geterror());
  }
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.width > largest_side ||
      spec.height > largest_side || spec.nchannels < 1 || spec.depth > 1) {
    throw Error(
        path.string(),
        fmt::format("has {} x {} pixels of {} channels", spec.width, spec.height, spec.nchannels),
        fmt::format("use a flat image of at most {} pixels a side", largest_side));
  }
  std::vector<float> values(static_cast<std::size_t>(spec.image_pixels()) *
                            static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data())) {
    throw Error(path.string(), "cannot be read as an image: " + input->geterror());
  }
  return film_image_from(spec, values);
}

}  // namespace foveola
