// The module that image_codec() loads: the only place that knows OpenImageIO.
#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "renderer/image/image_codec.h"

namespace foveola {
namespace {

using Bytes = std::span<const unsigned char>;

/// The file `encoded` without its alpha, by which decoders would multiply its colours. Keeps the
/// colours of invisible pixels, too, unless it is an animation (RFC 9649, sections 2.7 and 3.4).
std::vector<unsigned char> without_webp_alpha(Bytes encoded) {
  constexpr std::size_t first_chunk = 12;
  constexpr std::size_t chunk_header = 8;
  constexpr std::size_t size_of_flags = 5;
  constexpr unsigned char has_alpha = 0x10;
  std::vector<unsigned char> bytes(encoded.begin(), encoded.end());
  std::size_t at = first_chunk;
  while (at + chunk_header + size_of_flags <= bytes.size()) {
    unsigned char* const chunk = bytes.data() + at;
    const std::string_view kind(reinterpret_cast<const char*>(chunk), 4);
    const std::size_t size = std::size_t{chunk[4]} | std::size_t{chunk[5]} << 8 |
                             std::size_t{chunk[6]} << 16 | std::size_t{chunk[7]} << 24;
    unsigned char* const content = chunk + chunk_header;
    if (kind == "VP8X") {
      content[0] &= static_cast<unsigned char>(~has_alpha);
    } else if (kind == "VP8L") {
      content[4] &= static_cast<unsigned char>(~has_alpha);
    } else if (kind == "ALPH") {
      chunk[0] = 'X';  // decoders skip unknown chunks
    }
    at += chunk_header + size + size % 2;
  }
  return bytes;
}

/// OpenImageIO's reader of a file in memory.
class MemoryInput {
 public:
  MemoryInput(Bytes encoded, const std::string& format, bool (*is_stopped)())
      : memory_(encoded.data(), encoded.size()),
        input_(OIIO::ImageInput::create(format)),
        is_stopped_(is_stopped) {
    if (!input_) {
      throw std::runtime_error("cannot be read: OpenImageIO has no reader for " + format);
    }
    OIIO::ImageSpec wishes;
    wishes["oiio:UnassociatedAlpha"] = 1;
    input_->set_ioproxy(&memory_);
    require(input_->open("image." + format, spec_, wishes));
  }

  const OIIO::ImageSpec& spec() const { return spec_; }

  /// Reads the channels [first, end) of each pixel to every `stride`-th value.
  template <typename Value>
  void read(int first, int end, OIIO::TypeDesc type, Value* values, std::size_t stride) {
    const auto ends_reading = [](void* input, float /*portion_done*/) {
      return static_cast<const MemoryInput*>(input)->is_stopped_();
    };
    require(input_->read_image(0, 0, first, end, type, values,
                               static_cast<OIIO::stride_t>(stride * sizeof(Value)),
                               OIIO::AutoStride, OIIO::AutoStride, ends_reading, this));
  }

 private:
  void require(bool is_done) const {
    if (!is_done) {
      throw std::runtime_error("is damaged: " + input_->geterror());
    }
  }

  OIIO::Filesystem::IOMemReader memory_;  ///< read by `input_`, so destroyed after it
  std::unique_ptr<OIIO::ImageInput> input_;
  bool (*is_stopped_)();
  OIIO::ImageSpec spec_;
};

/// Whether OpenImageIO multiplies colours by alpha despite the request not to.
bool has_associated_alpha(const OIIO::ImageSpec& spec, const std::string& format) {
  return spec.alpha_channel >= 0 &&
         ((format == "tiff" && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0) ||
          (format == "targa" && spec.get_int_attribute("targa:alpha_type") == 4));
}

std::optional<std::array<float, 8>> chromaticities_of(const OIIO::ImageSpec& spec) {
  std::array<float, 8> values{};
  const bool is_there =
      spec.getattribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), values.data());
  return is_there ? std::optional(values) : std::nullopt;
}

class OpenImageIoReader : public ImageReader {
 public:
  OpenImageIoReader(Bytes encoded, const std::string& format, bool (*is_stopped)())
      : input_(encoded, format, is_stopped),
        is_associated_(has_associated_alpha(input_.spec(), format)) {
    const OIIO::ImageSpec& spec = input_.spec();
    const bool is_exr = format == "openexr";  // positions in other formats are for printing
    header_ = {.width = is_exr ? spec.full_width : spec.width,
               .height = is_exr ? spec.full_height : spec.height,
               .channels = spec.nchannels,
               .channel_names = spec.channelnames,
               .is_flat = spec.depth <= 1 && !spec.deep,
               .has_bytes = spec.format == OIIO::TypeDesc::UINT8,
               .has_floats = is_exr || spec.format.is_floating_point(),
               .stored_pixels = static_cast<std::size_t>(spec.image_pixels()),
               .block_bytes = spec.tile_bytes(true),
               .chromaticities = chromaticities_of(spec)};
    if (is_exr && spec.roi() != spec.roi_full()) {
      window_ = {spec.x - spec.full_x, spec.y - spec.full_y};
      header_.block_bytes =
          std::max<std::size_t>(header_.block_bytes, spec.image_pixels() * sizeof(float) * 3);
    }
    if (format == "webp" && spec.alpha_channel >= 0) {
      opaque_bytes_ = without_webp_alpha(encoded);
      opaque_input_ = std::make_unique<MemoryInput>(opaque_bytes_, format, is_stopped);
    }
  }

  const ImageHeader& header() const override { return header_; }

  void read_bytes(std::uint8_t* values) override {
    const auto channels = static_cast<std::size_t>(header_.channels);
    if (is_associated_) {
      std::vector<float> floats(header_.stored_pixels * channels);
      read_stored(0, header_.channels, floats.data(), channels);
      OIIO::convert_pixel_values(OIIO::TypeDesc::FLOAT, floats.data(), OIIO::TypeDesc::UINT8,
                                 values, static_cast<int>(floats.size()));
      return;
    }
    // Bytes unchanged: OpenImageIO converts even bytes to bytes through a buffer of 64 MiB.
    const OIIO::TypeDesc type = header_.has_bytes ? OIIO::TypeDesc::UNKNOWN : OIIO::TypeDesc::UINT8;
    read_channels(0, header_.channels, type, values, channels);
  }

  void read_floats(int first, int count, float* values, std::size_t stride) override {
    if (!window_) {
      read_stored(first, count, values, stride);
      return;
    }
    const OIIO::ImageSpec& spec = input_.spec();
    const auto channels = static_cast<std::size_t>(count);
    std::vector<float> stored(header_.stored_pixels * channels);
    read_stored(first, count, stored.data(), channels);
    for (int y = 0; y < header_.height; ++y) {
      for (int x = 0; x < header_.width; ++x, values += stride) {
        const int column = x - (*window_)[0];
        const int row = y - (*window_)[1];
        if (column < 0 || column >= spec.width || row < 0 || row >= spec.height) {
          std::fill_n(values, channels, 0.0F);
          continue;
        }
        const std::size_t pixel = static_cast<std::size_t>(row) * spec.width + column;
        std::copy_n(stored.data() + pixel * channels, channels, values);
      }
    }
  }

 private:
  void read_stored(int first, int count, float* values, std::size_t stride) {
    if (!is_associated_) {
      read_channels(first, first + count, OIIO::TypeDesc::FLOAT, values, stride);
      return;
    }
    const auto channels = static_cast<std::size_t>(header_.channels);
    const auto alpha = static_cast<std::size_t>(input_.spec().alpha_channel);
    std::vector<float> all(header_.stored_pixels * channels);
    input_.read(0, header_.channels, OIIO::TypeDesc::FLOAT, all.data(), channels);
    for (std::size_t pixel = 0; pixel < header_.stored_pixels; ++pixel) {
      const float* const stored = all.data() + pixel * channels;
      for (int i = 0; i < count; ++i) {
        const auto channel = static_cast<std::size_t>(first + i);
        const bool is_multiplied = channel != alpha && stored[alpha] > 0.0F;
        values[pixel * stride + static_cast<std::size_t>(i)] =
            is_multiplied ? stored[channel] / stored[alpha] : stored[channel];
      }
    }
  }

  template <typename Value>
  void read_channels(int first, int end, OIIO::TypeDesc type, Value* values, std::size_t stride) {
    input_.read(first, end, type, values, stride);
    const int opaque_end = opaque_input_ ? std::min(end, opaque_input_->spec().nchannels) : 0;
    if (first < opaque_end) {
      opaque_input_->read(first, opaque_end, type, values, stride);
    }
  }

  MemoryInput input_;
  /// Left and top of the file's window in the picture, if it is not all of it.
  std::optional<std::array<int, 2>> window_;
  bool is_associated_;
  ImageHeader header_;
  /// OpenImageIO multiplies a WebP's colours by its alpha: these bytes have none.
  std::vector<unsigned char> opaque_bytes_;
  std::unique_ptr<MemoryInput> opaque_input_;
};

std::unique_ptr<ImageReader> open_bytes(Bytes encoded, const std::string& format,
                                        bool (*is_stopped)()) {
  return std::make_unique<OpenImageIoReader>(encoded, format, is_stopped);
}

std::vector<unsigned char> encode(const EncodableImage& image, const std::string& format) {
  const bool has_bytes = !image.bytes.empty();
  const OIIO::TypeDesc type = has_bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT;
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channel_names.size()),
                       type);
  spec.channelnames = image.channel_names;
  if (has_bytes) {
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("Compression", "jpeg:95");  // read by that format alone
  } else {
    // Equal images give equal files, whatever the time.
    spec.attribute("DateTime", "");
  }
  for (const auto& [name, value] : image.attributes) {
    spec.attribute(name, value);
  }
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
  if (!output) {
    throw std::runtime_error(OIIO::geterror());
  }
  const void* const values = has_bytes ? static_cast<const void*>(image.bytes.data())
                                       : static_cast<const void*>(image.floats.data());
  std::vector<unsigned char> encoded;
  OIIO::Filesystem::IOVecOutput memory(encoded);
  if (!output->set_ioproxy(&memory) || !output->open("image." + format, spec) ||
      !output->write_image(type, values) || !output->close()) {
    throw std::runtime_error(output->geterror());
  }
  return encoded;
}

constexpr ImageCodec codec{.open_bytes = open_bytes, .encode = encode};

}  // namespace
}  // namespace foveola

extern "C" __attribute__((visibility("default"))) const foveola::ImageCodec* foveola_image_codec() {
  return &foveola::codec;
}
