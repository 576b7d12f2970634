#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/scene/load_scene.h"
#include "renderer/scene/srgb.h"

namespace foveola {
namespace {

/// 16384 x 8192, 1.6 GB.
constexpr std::int64_t most_pixels = std::int64_t{1} << 27;

/// Before OpenImageIO tries every format that it knows on the path.
void require_regular_file(const std::filesystem::path& path) {
  std::error_code failure;
  const auto status = std::filesystem::status(path, failure);
  if (!std::filesystem::exists(status)) {
    throw Error(path.string(), "no such file", "check the path");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw Error(path.string(), "is not a file", "name an equirect image");
  }
}

float light_of(float value) { return std::isfinite(value) ? std::max(value, 0.0F) : 0.0F; }

/// The first three of `channels` values, or the first alone as a grey.
Rgb colour_of(const float* values, int channels) {
  return channels >= 3 ? Rgb(light_of(values[0]), light_of(values[1]), light_of(values[2]))
                       : Rgb(light_of(values[0]));
}

void decode_srgb(std::vector<Rgb>& texels) {
  for (Rgb& texel : texels) {
    for (int channel = 0; channel < 3; ++channel) {
      texel[channel] = static_cast<float>(linear_from_srgb(texel[channel]));
    }
  }
}

}  // namespace

Environment load_environment(const std::filesystem::path& path) {
  require_regular_file(path);
  const auto fail = [&](const std::string& what) {
    throw Error(path.string(), what, "use an EXR, HDR, PNG or JPEG image");
  };
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string());
  if (!input) {
    fail("cannot be read as an image: " + OIIO::geterror());
  }
  const OIIO::ImageSpec& spec = input->spec();
  const int channels = std::min(spec.nchannels, 3);
  if (spec.width < 1 || spec.height < 1 || channels < 1 || spec.depth > 1) {
    fail("is not a two-dimensional image");
  }
  if (std::int64_t{spec.width} * spec.height > most_pixels) {
    fail(
        fmt::format("has {} x {} pixels; up to {} are read", spec.width, spec.height, most_pixels));
  }
  const bool is_srgb = !spec.format.is_floating_point();
  const std::size_t pixels = static_cast<std::size_t>(spec.width) * spec.height;
  std::vector<float> values(pixels * static_cast<std::size_t>(channels));
  if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, values.data())) {
    fail("is damaged: " + input->geterror());
  }
  Environment environment;
  environment.map_width = spec.width;
  environment.map_height = spec.height;
  environment.map.reserve(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    environment.map.push_back(
        colour_of(values.data() + i * static_cast<std::size_t>(channels), channels));
  }
  if (is_srgb) {
    decode_srgb(environment.map);
  }
  return environment;
}

}  // namespace foveola
