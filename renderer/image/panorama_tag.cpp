#include "renderer/image/panorama_tag.h"

#include <cstddef>

#include <boost/crc.hpp>
#include <fmt/format.h>

namespace foveola {
namespace {

std::string xmp_of(int width, int height) {
  return fmt::format(
      "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">"
      "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">"
      "<rdf:Description rdf:about=\"\" xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\""
      " GPano:ProjectionType=\"equirectangular\" GPano:UsePanoramaViewer=\"True\""
      " GPano:FullPanoWidthPixels=\"{0}\" GPano:FullPanoHeightPixels=\"{1}\""
      " GPano:CroppedAreaImageWidthPixels=\"{0}\" GPano:CroppedAreaImageHeightPixels=\"{1}\""
      " GPano:CroppedAreaLeftPixels=\"0\" GPano:CroppedAreaTopPixels=\"0\"/>"
      "</rdf:RDF></x:xmpmeta>",
      width, height);
}

std::string big_endian(std::size_t value, int bytes) {
  std::string text;
  for (int i = bytes; i-- > 0;) {
    text += static_cast<char>(value >> 8U * static_cast<unsigned>(i) & 0xFFU);
  }
  return text;
}

/// An iTXt chunk ("XMP Specification, part 3", section 1.1.5), uncompressed, in no language.
std::string png_chunk(const std::string& xmp) {
  using namespace std::string_literals;
  const std::string content = "iTXtXML:com.adobe.xmp\0\0\0\0\0"s + xmp;
  boost::crc_32_type checksum;  // that of PNG's chunks
  checksum.process_bytes(content.data(), content.size());
  return big_endian(content.size() - 4, 4) + content + big_endian(checksum.checksum(), 4);
}

/// An APP1 segment (section 1.1.3).
std::string jpeg_segment(const std::string& xmp) {
  using namespace std::string_literals;
  const std::string content = "http://ns.adobe.com/xap/1.0/\0"s + xmp;
  return "\xFF\xE1" + big_endian(content.size() + 2, 2) + content;
}

}  // namespace

std::string with_panorama_tag(std::string file, int width, int height) {
  const std::string xmp = xmp_of(width, height);
  if (file.starts_with("\x89PNG")) {
    constexpr std::size_t end_of_header = 8 + 25;  // the signature, and the chunk IHDR
    return file.insert(end_of_header, png_chunk(xmp));
  }
  // Behind the start of the image and JFIF's segment, whose length its third and fourth bytes say.
  const auto byte = [&](std::size_t at) {
    return static_cast<std::size_t>(static_cast<unsigned char>(file[at]));
  };
  const bool has_jfif = byte(3) == 0xE0;
  return file.insert(has_jfif ? 4 + (byte(4) << 8U) + byte(5) : 2, jpeg_segment(xmp));
}

}  // namespace foveola
