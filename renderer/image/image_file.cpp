#include "renderer/image/image_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/output_guard.h"
#include "renderer/image/image_codec.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

constexpr int largest_side = 65536;

/// How many pixels a header may promise: no image worth reading packs more of them into a byte.
constexpr std::uintmax_t most_pixels_per_byte = 4096;
constexpr std::uintmax_t always_allowed_pixels = 1U << 20;

/// Writes the image, which takes the place of an older file in one step.
void write_pixels(const fs::path& path, const EncodableImage& image) {
  const ImageCodec& codec = image_codec();
  replace_file(path, [&](const fs::path& temporary) {
    try {
      codec.write_file(temporary.string(), image);
    } catch (const std::runtime_error& fault) {
      throw Error(path.string(), std::string("cannot be written: ") + fault.what(),
                  "check the free space and permissions");
    }
  });
}

/// samples, variances: empty for no such channel.
void write_exr(const fs::path& path, const RgbImage& image,
               const std::vector<std::uint32_t>& samples, const std::vector<float>& variances,
               const ImageFacts& facts) {
  std::vector<std::string> names = {"R", "G", "B"};
  if (!samples.empty()) {
    names.emplace_back("samples");
  }
  if (!variances.empty()) {
    names.emplace_back("variance");
  }
  std::vector<float> values;
  values.reserve(image.pixels.size() * names.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    values.insert(values.end(), {image.pixels[i].r, image.pixels[i].g, image.pixels[i].b});
    if (!samples.empty()) {
      values.push_back(static_cast<float>(samples[i]));
    }
    if (!variances.empty()) {
      values.push_back(variances[i]);
    }
  }
  write_pixels(path, {.width = image.width,
                      .height = image.height,
                      .channel_names = names,
                      .attributes = {facts.begin(), facts.end()},
                      .bytes = {},
                      .floats = values});
}

void write_png(const fs::path& path, const RgbImage& linear, double exposure_stops,
               ToneCurve curve) {
  const RgbImage display = display_image(linear, exposure_stops, curve);
  std::vector<std::uint8_t> values;
  values.reserve(display.pixels.size() * 3);
  for (const Rgb& pixel : display.pixels) {
    for (int channel = 0; channel < 3; ++channel) {
      values.push_back(static_cast<std::uint8_t>(std::lround(pixel[channel] * 255.0F)));
    }
  }
  write_pixels(path, {.width = display.width,
                      .height = display.height,
                      .channel_names = {"R", "G", "B"},
                      .attributes = {},
                      .bytes = values,
                      .floats = {}});
}

/// Reads one channel after the other, so that a file with many of them costs no more memory.
class ChannelReader {
 public:
  ChannelReader(const fs::path& path, ImageReader& image) : path_(path), image_(image) {}

  /// Where the channel `name` is, or `fallback`.
  int index(const std::string& name, int fallback) const {
    const std::vector<std::string>& names = image_.header().channel_names;
    const auto found = std::find(names.begin(), names.end(), name);
    return found != names.end() ? static_cast<int>(found - names.begin()) : fallback;
  }

  /// Writes the values of a channel to every `stride`-th float from `first` on.
  void read(int channel, float* first, std::size_t stride) const {
    try {
      image_.read_floats(channel, 1, first, stride);
    } catch (const std::runtime_error& fault) {
      throw Error(path_.string(), std::string("cannot be read as an image: ") + fault.what());
    }
  }

 private:
  const fs::path& path_;
  ImageReader& image_;
};

RgbImage read_color(const ChannelReader& reader, const ImageHeader& header) {
  RgbImage color(header.width, header.height);
  const bool is_grey = header.channels < 3;
  const std::array<const char*, 3> names = {"R", "G", "B"};
  for (int channel = 0; channel < 3; ++channel) {
    const int index = is_grey ? 0 : reader.index(names[static_cast<std::size_t>(channel)], channel);
    reader.read(index, &color.pixels[0][channel], sizeof(Rgb) / sizeof(float));
  }
  if (header.has_bytes) {
    for (Rgb& pixel : color.pixels) {
      pixel = {linear_from_srgb(pixel.r), linear_from_srgb(pixel.g), linear_from_srgb(pixel.b)};
    }
  }
  return color;
}

/// A count that came as a float, whatever an untrusted file says.
std::uint32_t count_from(float value) {
  constexpr float largest = 0x1.fffffep31F;
  return value > 0.0F ? static_cast<std::uint32_t>(std::min(value, largest)) : 0;
}

std::vector<std::uint32_t> read_samples(const ChannelReader& reader, std::size_t pixels) {
  const int channel = reader.index("samples", -1);
  if (channel < 0) {
    return std::vector<std::uint32_t>(pixels, 1);
  }
  std::vector<float> values(pixels);
  reader.read(channel, values.data(), 1);
  std::vector<std::uint32_t> samples(pixels);
  std::transform(values.begin(), values.end(), samples.begin(), count_from);
  return samples;
}

void require_sensible(const fs::path& path, const ImageHeader& header) {
  if (header.width < 1 || header.height < 1 || header.width > largest_side ||
      header.height > largest_side || header.channels < 1 || !header.is_flat) {
    throw Error(path.string(),
                fmt::format("has {} x {} pixels of {} channels", header.width, header.height,
                            header.channels),
                fmt::format("use a flat image of at most {} pixels a side", largest_side));
  }
  const std::uintmax_t plausible =
      always_allowed_pixels + most_pixels_per_byte * fs::file_size(path);
  if (static_cast<std::uintmax_t>(header.width) * header.height > plausible) {
    throw Error(path.string(),
                fmt::format("is too short for the {} x {} pixels that it promises", header.width,
                            header.height),
                "check whether it is complete");
  }
}

std::unique_ptr<ImageReader> open_image(const fs::path& path) {
  if (!fs::is_regular_file(path)) {
    throw Error(path.string(), fs::exists(path) ? "is no file" : "no such file", "check the path");
  }
  require_no_output(path);
  const ImageCodec& codec = image_codec();
  std::unique_ptr<ImageReader> image;
  try {
    image = codec.open_file(path.string());
  } catch (const std::runtime_error& fault) {
    throw Error(path.string(), std::string("cannot be read as an image: ") + fault.what());
  }
  require_sensible(path, image->header());
  return image;
}

}  // namespace

void require_image_extension(const fs::path& path) {
  const std::string extension = lower_case_extension(path);
  if (extension != ".exr" && extension != ".png") {
    throw UsageError(path.string(),
                     fmt::format("'{}' is no image format to write", path.extension().string()),
                     "use .exr or .png");
  }
}

bool holds_radiance(const fs::path& path) { return lower_case_extension(path) == ".exr"; }

void write_film_image(const fs::path& path, const FilmImage& image, double exposure_stops,
                      const ImageFacts& facts, ToneCurve curve) {
  require_image_extension(path);
  if (holds_radiance(path)) {
    write_exr(path, image.color, image.samples, image.variances, facts);
  } else {
    write_png(path, image.color, exposure_stops, curve);
  }
}

void write_image(const fs::path& path, const RgbImage& image, double exposure_stops,
                 ToneCurve curve) {
  write_film_image(path, {.color = image, .samples = {}, .variances = {}}, exposure_stops, {},
                   curve);
}

IVec2 image_size(const fs::path& path) {
  const ImageHeader header = open_image(path)->header();
  return {header.width, header.height};
}

FilmImage read_film_image(const fs::path& path) {
  const std::unique_ptr<ImageReader> file = open_image(path);
  const ChannelReader reader(path, *file);
  FilmImage image{.color = read_color(reader, file->header()), .samples = {}, .variances = {}};
  image.samples = read_samples(reader, image.color.pixels.size());
  const int variance = reader.index("variance", -1);
  if (variance >= 0) {
    image.variances.resize(image.color.pixels.size());
    reader.read(variance, image.variances.data(), 1);
  }
  return image;
}

}  // namespace foveola
