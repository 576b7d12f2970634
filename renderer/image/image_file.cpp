#include "renderer/image/image_file.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include <boost/crc.hpp>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/image/encoded_image.h"
#include "renderer/image/image_codec.h"
#include "renderer/image/linear_color.h"

namespace fs = std::filesystem;
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

/// `file`, the bytes of a PNG or JPEG image of width x height pixels, with XMP of Google's
/// "Photo Sphere XMP Metadata": a whole equirectangular panorama.
std::string with_panorama_tag(std::string file, int width, int height) {
  const std::string xmp = xmp_of(width, height);
  if (file.starts_with("\x89PNG")) {
    constexpr std::size_t end_of_header = 8 + 25;  // the signature, and the chunk IHDR
    return file.insert(end_of_header, png_chunk(xmp));
  }
  // Behind the start of the image and JFIF's segment: its third and fourth bytes are its length.
  const auto byte = [&](std::size_t at) {
    return static_cast<std::size_t>(static_cast<unsigned char>(file[at]));
  };
  const bool has_jfif = byte(3) == 0xE0;
  return file.insert(has_jfif ? 4 + (byte(4) << 8U) + byte(5) : 2, jpeg_segment(xmp));
}

/// OpenImageIO's name of the format for a file of this name; empty if it is not supported.
std::string format_to_write(const fs::path& path) {
  const std::string extension = lower_case_extension(path);
  if (extension == ".exr") {
    return "openexr";
  }
  if (extension == ".png") {
    return "png";
  }
  return extension == ".jpg" || extension == ".jpeg" ? "jpeg" : "";
}

std::string encode_for(const fs::path& path, const EncodableImage& image) {
  try {
    const std::vector<unsigned char> bytes = image_codec().encode(image, format_to_write(path));
    return {bytes.begin(), bytes.end()};
  } catch (const std::runtime_error& fault) {
    throw Error(path.string(), std::string("cannot be encoded: ") + fault.what(),
                "choose another format or size");
  }
}

/// Writes R, G, B and, unless empty, the channels `samples` and `variance`. `facts` become
/// attributes of the header. Throws Error.
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
  write_file(path, encode_for(path, {.width = image.width,
                                     .height = image.height,
                                     .channel_names = names,
                                     .attributes = {facts.begin(), facts.end()},
                                     .bytes = {},
                                     .floats = values}));
}

/// As .png or .jpg.
void write_shown(const fs::path& path, const RgbImage& linear, double exposure_stops,
                 ToneCurve curve, bool is_panorama) {
  const RgbImage display = display_image(linear, exposure_stops, curve);
  std::vector<std::uint8_t> values;
  values.reserve(display.pixels.size() * 3);
  for (const Rgb& pixel : display.pixels) {
    for (int channel = 0; channel < 3; ++channel) {
      values.push_back(static_cast<std::uint8_t>(std::lround(pixel[channel] * 255.0F)));
    }
  }
  std::string file = encode_for(path, {.width = display.width,
                                       .height = display.height,
                                       .channel_names = {"R", "G", "B"},
                                       .attributes = {},
                                       .bytes = values,
                                       .floats = {}});
  if (is_panorama) {
    file = with_panorama_tag(std::move(file), display.width, display.height);
  }
  write_file(path, file);
}

/// A picture whose colours have not been read yet.
struct OpenPicture {
  std::string encoded;
  std::unique_ptr<ImageReader> reader;

  /// The pixels' values of the channel `name`; empty if there is no such channel.
  std::vector<float> values_of(const std::string& name) const {
    const ImageHeader& header = reader->header();
    const auto found = std::ranges::find(header.channel_names, name);
    if (found == header.channel_names.end()) {
      return {};
    }
    std::vector<float> values(static_cast<std::size_t>(header.width) * header.height);
    reader->read_floats(static_cast<int>(found - header.channel_names.begin()), 1, values.data(),
                        1);
    return values;
  }
};

/// Calls `work` with the picture at `path`; turns its faults into an Error that names the file.
template <typename Work>
auto with_picture(const fs::path& path, Work work) {
  OpenPicture picture{.encoded = read_file(path), .reader = nullptr};
  try {
    picture.reader = open_image(
        {reinterpret_cast<const unsigned char*>(picture.encoded.data()), picture.encoded.size()},
        ImageFormats::picture);
    return work(picture);
  } catch (const std::runtime_error& fault) {
    throw Error(path.string(), std::string("cannot be read as an image: ") + fault.what());
  }
}

/// A count stored as a float in an untrusted file.
std::uint32_t count_from(float value) {
  constexpr float largest = 0x1.fffffep31F;
  return value > 0.0F ? static_cast<std::uint32_t>(std::min(value, largest)) : 0;
}

}  // namespace

void require_image_extension(const fs::path& path) {
  if (format_to_write(path).empty()) {
    throw UsageError(path.string(),
                     fmt::format("'{}' is not an image format to write", path.extension().string()),
                     "use .exr, .png or .jpg");
  }
}

bool holds_radiance(const fs::path& path) { return lower_case_extension(path) == ".exr"; }

void write_film_image(const fs::path& path, const FilmImage& image, double exposure_stops,
                      const ImageFacts& facts, ToneCurve curve) {
  require_image_extension(path);
  if (holds_radiance(path)) {
    write_exr(path, image.color, image.samples, image.variances, facts);
  } else {
    const auto projection = facts.find(projection_fact);
    write_shown(path, image.color, exposure_stops, curve,
                projection != facts.end() && projection->second == panorama_projection);
  }
}

void write_image(const fs::path& path, const RgbImage& image, double exposure_stops,
                 ToneCurve curve) {
  write_film_image(path, {.color = image, .samples = {}, .variances = {}}, exposure_stops, {},
                   curve);
}

IVec2 image_size(const fs::path& path) {
  return with_picture(path, [](const OpenPicture& picture) {
    const ImageHeader& header = picture.reader->header();
    return IVec2(header.width, header.height);
  });
}

FilmImage read_film_image(const fs::path& path) {
  return with_picture(path, [](const OpenPicture& picture) {
    if (!has_valid_primaries(picture.reader->header())) {
      throw std::runtime_error("has primaries that span no colour space");
    }
    FilmImage image{.color = read_linear_color(*picture.reader),
                    .samples = {},
                    .variances = picture.values_of("variance")};
    const std::vector<float> counts = picture.values_of("samples");
    image.samples.assign(image.color.pixels.size(), 1);
    std::transform(counts.begin(), counts.end(), image.samples.begin(), count_from);
    return image;
  });
}

}  // namespace foveola
