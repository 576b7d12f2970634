// The module that image_codec() loads: the only place that knows OpenImageIO.
#include <fstream>
#include <stdexcept>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "renderer/image/image_codec.h"

namespace foveola {
namespace {

ImageHeader header_of(const OIIO::ImageSpec& spec) {
  return {.width = spec.width,
          .height = spec.height,
          .channels = spec.nchannels,
          .channel_names = spec.channelnames,
          .is_flat = spec.depth <= 1 && !spec.deep,
          .has_bytes = spec.format == OIIO::TypeDesc::UINT8,
          .has_floats = spec.format.is_floating_point(),
          .tile_bytes = spec.tile_bytes(true)};
}

class OpenImageIoReader : public ImageReader {
 public:
  explicit OpenImageIoReader(const std::string& path) : input_(OIIO::ImageInput::open(path)) {
    if (!input_) {
      throw std::runtime_error(OIIO::geterror());
    }
    header_ = header_of(input_->spec());
  }

  OpenImageIoReader(std::span<const unsigned char> encoded, const std::string& format)
      : memory_(std::make_unique<OIIO::Filesystem::IOMemReader>(encoded.data(), encoded.size())),
        input_(OIIO::ImageInput::create(format)),
        fault_("is damaged: ") {
    if (!input_) {
      throw std::runtime_error("cannot be read: OpenImageIO has no reader for " + format);
    }
    OIIO::ImageSpec wishes;
    wishes["oiio:UnassociatedAlpha"] = 1;
    input_->set_ioproxy(memory_.get());
    OIIO::ImageSpec spec;
    require(input_->open("image." + format, spec, wishes));
    header_ = header_of(spec);
  }

  const ImageHeader& header() const override { return header_; }

  void read_bytes(std::uint8_t* values) override {
    // Bytes as they are: OpenImageIO converts even bytes to bytes by way of a buffer of 64 MiB.
    const OIIO::TypeDesc type = header_.has_bytes ? OIIO::TypeDesc::UNKNOWN : OIIO::TypeDesc::UINT8;
    require(input_->read_image(0, 0, 0, header_.channels, type, values));
  }

  void read_floats(int first, int count, float* values, std::size_t stride) override {
    require(input_->read_image(0, 0, first, first + count, OIIO::TypeDesc::FLOAT, values,
                               static_cast<OIIO::stride_t>(stride * sizeof(float))));
  }

 private:
  void require(bool is_done) const {
    if (!is_done) {
      throw std::runtime_error(fault_ + input_->geterror());
    }
  }

  std::unique_ptr<OIIO::Filesystem::IOProxy> memory_;  ///< read by `input_`, so it dies after it
  std::unique_ptr<OIIO::ImageInput> input_;
  std::string fault_;  ///< what a fault's text begins with
  ImageHeader header_;
};

std::unique_ptr<ImageReader> open_file(const std::string& path) {
  return std::make_unique<OpenImageIoReader>(path);
}

std::unique_ptr<ImageReader> open_bytes(std::span<const unsigned char> encoded,
                                        const std::string& format) {
  return std::make_unique<OpenImageIoReader>(encoded, format);
}

void write_file(const std::string& path, const EncodableImage& image) {
  const bool has_bytes = !image.bytes.empty();
  const OIIO::TypeDesc type = has_bytes ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT;
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channel_names.size()),
                       type);
  spec.channelnames = image.channel_names;
  if (has_bytes) {
    spec.attribute("oiio:ColorSpace", "sRGB");
  } else {
    // The same image is the same file, whenever it is made.
    spec.attribute("DateTime", "");
  }
  for (const auto& [name, value] : image.attributes) {
    spec.attribute(name, value);
  }
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(path);
  if (!output) {
    throw std::runtime_error(OIIO::geterror());
  }
  const void* const values = has_bytes ? static_cast<const void*>(image.bytes.data())
                                       : static_cast<const void*>(image.floats.data());
  // In memory first: OpenImageIO does not notice that a PNG finds no room on the disk.
  std::vector<unsigned char> encoded;
  OIIO::Filesystem::IOVecOutput memory(encoded);
  if (!output->set_ioproxy(&memory) || !output->open(path, spec) ||
      !output->write_image(type, values) || !output->close()) {
    throw std::runtime_error(output->geterror());
  }
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(encoded.data()),
             static_cast<std::streamsize>(encoded.size()));
  file.close();
  if (!file) {
    throw std::runtime_error("the disk does not take it");
  }
}

constexpr ImageCodec codec{
    .open_file = open_file, .open_bytes = open_bytes, .write_file = write_file};

}  // namespace
}  // namespace foveola

extern "C" __attribute__((visibility("default"))) const foveola::ImageCodec* foveola_image_codec() {
  return &foveola::codec;
}
