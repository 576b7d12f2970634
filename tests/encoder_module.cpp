#include <memory>
#include <stdexcept>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "tests/encoded_image.h"

namespace foveola::test {
namespace {

void require(bool is_done, const OIIO::ImageOutput& output) {
  if (!is_done) {
    throw std::runtime_error(output.geterror());
  }
}

OIIO::ImageSpec spec_of(const EncodableSamples& image) {
  constexpr OIIO::TypeDesc::BASETYPE types[] = {OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16,
                                                OIIO::TypeDesc::FLOAT};
  OIIO::ImageSpec spec(image.width, image.height, image.channels, types[image.samples.index()]);
  if (!image.channel_names.empty()) {
    spec.channelnames = image.channel_names;
  }
  spec.tile_width = image.tile_side;
  spec.tile_height = image.tile_side;
  spec["oiio:UnassociatedAlpha"] = 1;
  return spec;
}

std::string encode(const EncodableSamples& image) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(image.format);
  output->set_ioproxy(&memory);
  const OIIO::ImageSpec spec = spec_of(image);
  const void* const samples = std::visit(
      [](const auto& values) { return static_cast<const void*>(values.data()); }, image.samples);
  require(output->open("image." + image.format, spec), *output);
  require(output->write_image(spec.format, samples), *output);
  require(output->close(), *output);
  return {bytes.begin(), bytes.end()};
}

}  // namespace
}  // namespace foveola::test

extern "C" __attribute__((visibility("default"))) void foveola_test_encode(
    const foveola::test::EncodableSamples& image, std::string& bytes) {
  bytes = foveola::test::encode(image);
}
