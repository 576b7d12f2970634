// A two-dimensional texture, stored in 8 bits and the image's own channels.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "renderer/base/vec.h"
#include "renderer/scene/textures/image_decoder.h"
#include "renderer/scene/textures/mip_chain.h"

namespace foveola {

/// The texels of textures: an image with its coarser levels, which several textures can share.
class Texels {
 public:
  /// is_srgb: whether grey or red, green and blue are sRGB-encoded; alpha never is. with_mips:
  /// whether coarser levels are built, for a third more memory. has_opacity: whether alpha is an
  /// opacity, which weights the other channels.
  Texels(DecodedImage image, bool is_srgb, bool with_mips, bool has_opacity = false);

  /// Levels of `channels()` interleaved bytes per texel, the image itself first.
  const std::vector<MipLevel>& levels() const { return levels_; }
  const std::uint8_t* codes() const { return codes_.data(); }
  int channels() const { return channels_; }
  bool is_srgb() const { return is_srgb_; }
  bool has_opacity() const { return has_opacity_; }

  std::size_t memory_bytes() const;

 private:
  std::vector<MipLevel> levels_;
  std::vector<std::uint8_t> codes_;
  int channels_;
  bool is_srgb_;
  bool has_opacity_;
};

enum class Wrap : std::uint8_t { repeat, clamp_to_edge, mirrored_repeat };
enum class Filter : std::uint8_t { nearest, linear };
/// Choice of levels for footprints wider than a texel; none: always the finest.
enum class MipFilter : std::uint8_t { none, nearest, linear };

/// glTF's sampler (specification, section 3.8.4.1): wrapping and filters.
struct Sampler {
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  Filter magnification = Filter::linear;  ///< for texels wider than the footprint
  Filter minification = Filter::linear;   ///< within a level, for narrower texels
  MipFilter mip = MipFilter::linear;      ///< between levels

  auto operator<=>(const Sampler&) const = default;
};

/// Row-major texels, first row at v = 0 (glTF's top). A grey is read as equal red, green and blue,
/// a missing alpha as 1.
class Texture {
 public:
  /// Uses the coarser levels, if present, unless the sampler says otherwise.
  Texture(std::shared_ptr<const Texels> texels, const Sampler& sampler);

  /// With its own texels; see Texels. Without mips, all footprints read the finest level.
  Texture(DecodedImage image, bool is_srgb, const Sampler& sampler, bool with_mips = true);

  /// texels: 4 * width * height bytes of red, green, blue, alpha.
  Texture(int width, int height, std::vector<std::uint8_t> texels, bool is_srgb, Wrap wrap_u,
          Wrap wrap_v);

  int width() const { return levels_[0].width; }
  int height() const { return levels_[0].height; }
  /// The image, which other textures may share.
  const Texels& texels() const { return *texels_; }

  /// The linear value at `uv` of any magnitude, in the finest level with the magnification filter;
  /// texel centres lie at half-integers. A non-finite uv reads texel (0, 0).
  Vec4 sample(const Vec2& uv) const;

  /// The linear value of a footprint around `uv` of width `uv_width`, in the unit of uv. In the
  /// level used, a texel is as wide as the footprint along the image's longer side. A width that is
  /// zero, negative or not finite reads the finest level.
  Vec4 sample(const Vec2& uv, float uv_width) const;

  /// Prefetches the texels that sample() will read from the finer of its levels.
  void prefetch(const Vec2& uv, float uv_width) const;

 private:
  /// The levels that a footprint reads, and their filter.
  struct Levels {
    std::size_t finer;
    float weight_coarser;  ///< of the next level
    Filter filter;
  };
  Levels levels_for(float uv_width) const;
  Vec4 sample_level(const MipLevel& level, Filter filter, const Vec2& uv) const;

  std::shared_ptr<const Texels> texels_;
  // Copies of the most read values of the texels.
  std::span<const MipLevel> levels_;  ///< the image itself first
  const std::uint8_t* codes_;
  const float* linear_from_byte_;  ///< 256 values that live as long as the program
  int channels_;
  Sampler sampler_;
};

}  // namespace foveola
