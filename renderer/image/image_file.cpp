#include "renderer/image/image_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/image/tone_mapping.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

constexpr int largest_side = 65536;

/// How many pixels a header may promise: no image worth reading packs more of them into a byte.
constexpr std::uintmax_t most_pixels_per_byte = 4096;
constexpr std::uintmax_t always_allowed_pixels = 1U << 20;

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
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(names.size()),
                       OIIO::TypeDesc::FLOAT);
  spec.channelnames = names;
  for (const auto& [name, value] : facts) {
    spec.attribute(name, value);
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

/// Reads one channel after the other, so that a file with many of them costs no more memory.
class ChannelReader {
 public:
  ChannelReader(const fs::path& path, OIIO::ImageInput& input) : path_(path), input_(input) {}

  /// Where the channel `name` is, or `fallback`.
  int index(const std::string& name, int fallback) const {
    const int found = input_.spec().channelindex(name);
    return found >= 0 ? found : fallback;
  }

  /// Writes the values of a channel to every `stride`-th float from `first` on.
  void read(int channel, float* first, std::size_t stride) const {
    if (!input_.read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::FLOAT, first,
                           static_cast<OIIO::stride_t>(stride * sizeof(float)))) {
      throw Error(path_.string(), "cannot be read as an image: " + input_.geterror());
    }
  }

 private:
  const fs::path& path_;
  OIIO::ImageInput& input_;
};

RgbImage read_color(const ChannelReader& reader, const OIIO::ImageSpec& spec) {
  RgbImage color(spec.width, spec.height);
  const bool is_grey = spec.nchannels < 3;
  const std::array<const char*, 3> names = {"R", "G", "B"};
  for (int channel = 0; channel < 3; ++channel) {
    const int index = is_grey ? 0 : reader.index(names[static_cast<std::size_t>(channel)], channel);
    reader.read(index, &color.pixels[0][channel], sizeof(Rgb) / sizeof(float));
  }
  if (spec.format.basetype == OIIO::TypeDesc::UINT8) {
    for (Rgb& pixel : color.pixels) {
      pixel = {linear_from_srgb(pixel.r), linear_from_srgb(pixel.g), linear_from_srgb(pixel.b)};
    }
  }
  return color;
}

/// A count that came as a float, whatever a stranger's file says.
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

void require_sensible(const fs::path& path, const OIIO::ImageSpec& spec) {
  if (spec.width < 1 || spec.height < 1 || spec.width > largest_side ||
      spec.height > largest_side || spec.nchannels < 1 || spec.depth > 1 || spec.deep) {
    throw Error(
        path.string(),
        fmt::format("has {} x {} pixels of {} channels", spec.width, spec.height, spec.nchannels),
        fmt::format("use a flat image of at most {} pixels a side", largest_side));
  }
  const std::uintmax_t plausible =
      always_allowed_pixels + most_pixels_per_byte * fs::file_size(path);
  if (spec.image_pixels() > plausible) {
    throw Error(path.string(),
                fmt::format("is too short for the {} x {} pixels that it promises", spec.width,
                            spec.height),
                "check whether it is complete");
  }
}

std::unique_ptr<OIIO::ImageInput> open_image(const fs::path& path) {
  if (!fs::is_regular_file(path)) {
    throw Error(path.string(), fs::exists(path) ? "is no file" : "no such file", "check the path");
  }
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string());
  if (!input) {
    throw Error(path.string(), "cannot be read as an image: " + OIIO::geterror());
  }
  require_sensible(path, input->spec());
  return input;
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

void write_film_image(const fs::path& path, const FilmImage& image, double exposure_stops,
                      const ImageFacts& facts) {
  require_image_extension(path);
  if (lower_extension(path) == ".exr") {
    write_exr(path, image.color, image.samples, image.variances, facts);
  } else {
    write_png(path, image.color, exposure_stops);
  }
}

void write_image(const fs::path& path, const RgbImage& image, double exposure_stops) {
  write_film_image(path, {.color = image, .samples = {}, .variances = {}}, exposure_stops);
}

IVec2 image_size(const fs::path& path) {
  const OIIO::ImageSpec spec = open_image(path)->spec();
  return {spec.width, spec.height};
}

FilmImage read_film_image(const fs::path& path) {
  const std::unique_ptr<OIIO::ImageInput> input = open_image(path);
  const OIIO::ImageSpec& spec = input->spec();
  const ChannelReader reader(path, *input);
  FilmImage image{.color = read_color(reader, spec), .samples = {}, .variances = {}};
  image.samples = read_samples(reader, image.color.pixels.size());
  const int variance = reader.index("variance", -1);
  if (variance >= 0) {
    image.variances.resize(image.color.pixels.size());
    reader.read(variance, image.variances.data(), 1);
  }
  return image;
}

}  // namespace foveola
