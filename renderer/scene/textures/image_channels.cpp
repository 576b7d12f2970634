#include "renderer/scene/textures/image_channels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace foveola {
namespace {

/// A channel of an image, resampled to some size; 255 everywhere without an image.
struct Source {
  const DecodedImage* image;
  int channel;

  std::uint8_t at(int x, int y, int width, int height) const {
    if (image == nullptr) {
      return 255;
    }
    const auto column = static_cast<std::size_t>(std::int64_t{x} * image->width / width);
    const auto row = static_cast<std::size_t>(std::int64_t{y} * image->height / height);
    const std::size_t texel = row * static_cast<std::size_t>(image->width) + column;
    return image->texels[texel * static_cast<std::size_t>(image->channels) +
                         static_cast<std::size_t>(channel)];
  }
};

std::size_t pixels_of(const DecodedImage& image) {
  return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

DecodedImage merged(const std::vector<Source>& sources) {
  const DecodedImage* largest = nullptr;
  for (const Source& source : sources) {
    if (source.image != nullptr &&
        (largest == nullptr || pixels_of(*source.image) > pixels_of(*largest))) {
      largest = source.image;
    }
  }
  DecodedImage result{.width = largest->width,
                      .height = largest->height,
                      .channels = static_cast<int>(sources.size()),
                      .texels = {}};
  result.texels.reserve(sources.size() * pixels_of(result));
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      for (const Source& source : sources) {
        result.texels.push_back(source.at(x, y, result.width, result.height));
      }
    }
  }
  return result;
}

int alpha_channel(const DecodedImage& image) {
  return image.channels % 2 == 0 ? image.channels - 1 : -1;
}

bool is_used(const DecodedImage& image, int channel) {
  const auto step = static_cast<std::size_t>(image.channels);
  for (auto i = static_cast<std::size_t>(channel); i < image.texels.size(); i += step) {
    if (image.texels[i] != 255) {
      return true;
    }
  }
  return false;
}

const DecodedImage* pointer_to(const std::optional<DecodedImage>& image) {
  return image ? &*image : nullptr;
}

}  // namespace

DecodedImage with_alpha(const std::optional<DecodedImage>& color, const DecodedImage& mask) {
  const int alpha = alpha_channel(mask);
  const Source mask_source{.image = &mask,
                           .channel = alpha >= 0 && is_used(mask, alpha) ? alpha : 0};
  const DecodedImage* image = pointer_to(color);
  if (image == nullptr || image->channels <= 2) {
    return merged({{image, 0}, mask_source});
  }
  return merged({{image, 0}, {image, 1}, {image, 2}, mask_source});
}

DecodedImage roughness_metallic(const std::optional<DecodedImage>& roughness,
                                const std::optional<DecodedImage>& metallic) {
  return merged({{nullptr, 0}, {pointer_to(roughness), 0}, {pointer_to(metallic), 0}});
}

DecodedImage roughness_of_glossiness(const DecodedImage& image, float factor) {
  const int alpha = alpha_channel(image);
  DecodedImage result = merged({{nullptr, 0}, {&image, std::max(alpha, 0)}, {nullptr, 0}});
  for (std::size_t i = 1; i < result.texels.size(); i += 3) {
    const float glossiness = alpha < 0 ? 255.0F : static_cast<float>(result.texels[i]);
    result.texels[i] = static_cast<std::uint8_t>(std::lround(255.0F - factor * glossiness));
  }
  return result;
}

}  // namespace foveola
