#include "renderer/scene/textures/image_decoder.h"

#include <filesystem>
#include <stdexcept>

#include "renderer/base/files/files.h"
#include "tests/encoded_image.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

std::span<const unsigned char> bytes_of(const std::string& encoded) {
  return {reinterpret_cast<const unsigned char*>(encoded.data()), encoded.size()};
}

DecodedImage decode(const std::string& encoded) { return decode_image(bytes_of(encoded)); }

std::string image_fault(const std::string& encoded,
                        ImageFormats formats = ImageFormats::gltf_texture) {
  try {
    decode_image(bytes_of(encoded), formats);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  ADD_FAILURE() << "decoded without an error";
  return {};
}

TEST(ImageDecoder, KeepsEightBitsAsTheyAre) {
  const DecodedImage image =
      decode(png(2, 1, 4, std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6, 7, 255}));
  EXPECT_EQ(image.width, 2);
  EXPECT_EQ(image.height, 1);
  EXPECT_THAT(image.texels, ElementsAre(1, 2, 3, 4, 5, 6, 7, 255)) << "colour not times alpha";
}

TEST(ImageDecoder, KeepsTheChannelsThatThereAre) {
  const std::vector<std::uint8_t> samples{1, 2, 3, 4, 5, 6, 7, 0, 9, 10, 11, 12};
  for (const int channels : {1, 2, 3, 4}) {
    const DecodedImage image = decode(png(12 / channels, 1, channels, samples));
    EXPECT_EQ(image.channels, channels);
    EXPECT_EQ(image.texels, samples);
  }
}

TEST(ImageDecoder, RowsRunDownwards) {
  const DecodedImage image = decode(png(1, 2, 1, std::vector<std::uint8_t>{10, 20}));
  EXPECT_EQ(image.height, 2);
  EXPECT_THAT(image.texels, ElementsAre(10, 20));
}

/// 65535 / 255 = 257.
TEST(ImageDecoder, SixteenBitsBecomeEight) {
  EXPECT_THAT(decode(png(1, 1, 3, std::vector<std::uint16_t>{0, 128 * 257, 65535})).texels,
              ElementsAre(0, 128, 255));
}

TEST(ImageDecoder, DecodesJpeg) {
  const DecodedImage image = decode(jpeg(9, 5, 77));
  EXPECT_EQ(image.channels, 3);
  ASSERT_EQ(image.texels.size(), 3U * 9U * 5U);
  EXPECT_NEAR(image.texels[0], 77, 1);
}

TEST(ImageDecoder, KnowsTheSizeBeforehand) {
  const ImageSize size = size_of_image(bytes_of(jpeg(9, 5, 77)));
  EXPECT_EQ(size.width, 9);
  EXPECT_EQ(size.pixels(), 45U);
  EXPECT_EQ(size.bytes(), 135U);
}

TEST(ImageDecoder, RefusesOtherFormats) {
  for (const char* encoded : {"GIF89a......", "", "\x89PN", "BM......"}) {
    EXPECT_EQ(image_fault(encoded), "is not a PNG, JPEG or WebP image") << encoded;
  }
  EXPECT_EQ(image_fault("this is no image", ImageFormats::any_texture),
            "is not a PNG, JPEG, WebP, BMP, GIF, TGA or TIFF image");
  EXPECT_THAT(image_fault("\xABKTX 20\xBB\r\n\x1A\n"), HasSubstr("export it as PNG or JPEG"));
}

/// What OpenImageIO writes in the formats that OBJ files have beside glTF's.
TEST(ImageDecoder, ReadsOtherFormatsWhereTheyAreAllowed) {
  for (const char* format : {"bmp", "targa", "tiff"}) {
    const std::string encoded =
        encoded_image({format, 2, 1, 3, std::vector<std::uint8_t>{1, 2, 3, 200, 100, 50}});
    const DecodedImage image = decode_image(bytes_of(encoded), ImageFormats::any_texture);
    EXPECT_EQ(image.width, 2) << format;
    EXPECT_THAT(image.texels, ElementsAre(1, 2, 3, 200, 100, 50)) << format;
    EXPECT_THAT(image_fault(encoded), HasSubstr("is not a PNG")) << format;
    for (std::size_t size = 0; size < encoded.size(); ++size) {
      try {
        decode_image(bytes_of(encoded.substr(0, size)), ImageFormats::any_texture);
      } catch (const std::runtime_error&) {  // a cut one may be shown as far as it goes
      }
    }
  }
}

TEST(ImageDecoder, ReadsWebP) {
  const std::string encoded =
      encoded_image({"webp", 16, 8, 4, std::vector<std::uint8_t>(16 * 8 * 4, 255)});
  const DecodedImage image = decode(encoded);
  EXPECT_EQ(image.width, 16);
  EXPECT_EQ(image.height, 8);
  EXPECT_NEAR(image.texels[0], 255, 2);
  for (std::size_t size = 4; size + 16 < encoded.size(); ++size) {
    EXPECT_THAT(image_fault(encoded.substr(0, size)), HasSubstr("is ")) << size;
  }
}

std::string content_of_picture(const std::string& name) {
  return read_file(std::filesystem::path(TEST_DATA_DIR) / "pictures" / name);
}

/// Whatever a decoder does with alpha by itself.
TEST(ImageDecoder, OnePictureHasTheSameTexelsInEveryFormat) {
  const std::vector<std::uint8_t> texels{200, 30, 30, 128, 9, 80, 255, 1,
                                         40,  50, 60, 0,   1, 2,  3,   255};
  for (const char* format : {"png", "targa", "tiff"}) {
    const std::string encoded = encoded_image({format, 4, 1, 4, texels});
    EXPECT_EQ(decode_image(bytes_of(encoded), ImageFormats::any_texture).texels, texels) << format;
  }
  const DecodedImage webp = decode(content_of_picture("tx_alpha128.webp"));
  EXPECT_EQ(webp.texels, decode(content_of_picture("tx_alpha128.png")).texels);
  EXPECT_THAT(std::vector(webp.texels.begin(), webp.texels.begin() + 4),
              ElementsAre(200, 30, 30, 128));
}

/// 100 of 255 is 200 times 128 / 255, in whole numbers within 1.
TEST(ImageDecoder, AssociatedAlphaIsTakenOut) {
  const std::string encoded = content_of_picture("associated.tif");
  const DecodedImage image = decode_image(bytes_of(encoded), ImageFormats::any_texture);
  const std::vector<int> above{200, 100, 50, 128};
  for (std::size_t i = 0; i < above.size(); ++i) {
    EXPECT_NEAR(image.texels[i], above[i], 1);
  }
  // A TGA of one pixel whose extension area says so ("TGA File Format Specification" 2.0, field
  // 24).
  std::string targa("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\x20\x08\x19\x32\x64\x80", 22);
  const std::string extension = "\xEF\1" + std::string(492, '\0') + '\4';
  targa += extension + std::string("\x16\0\0\0\0\0\0\0TRUEVISION-XFILE.\0", 26);
  const DecodedImage pixel = decode_image(bytes_of(targa), ImageFormats::any_texture);
  for (std::size_t i = 0; i < above.size(); ++i) {
    EXPECT_NEAR(pixel.texels[i], above[i], 1);
  }
}

TEST(ImageDecoder, FloatsAreLinearAndBecomeSrgbCodesOfColours) {
  const std::string encoded = content_of_picture("float.tif");
  EXPECT_THAT(decode_image(bytes_of(encoded), ImageFormats::any_texture, true).texels,
              AllOf(Contains(200), Contains(100), Contains(50), Each(AnyOf(200, 100, 50))));
}

/// A lossless one's header: 14 bits for each side less 1.
TEST(ImageDecoder, RefusesAHugeWebPBeforeItIsDecoded) {
  const std::string header("RIFF\x1A\0\0\0WEBPVP8L\x0D\0\0\0\x2F\xFF\xFF\xFF\x0F", 25);
  EXPECT_EQ(image_fault(header + std::string(8, '\0')),
            "has 268435456 pixels; up to 67108864 of a WebP image are read");
}

TEST(ImageDecoder, RefusesDamagedImages) {
  std::string spoilt = png(8, 8, 3, std::vector<std::uint8_t>(8 * 8 * 3, 5));
  spoilt[60] = static_cast<char>(spoilt[60] ^ 0x55);
  EXPECT_THAT(image_fault(spoilt), HasSubstr("is damaged"));
  EXPECT_THAT(image_fault("\xFF\xD8\xFF\xD9"), HasSubstr("is damaged"));
}

TEST(ImageDecoder, RefusesACutPng) {
  const std::string whole = png(8, 8, 3, std::vector<std::uint8_t>(8 * 8 * 3, 5));
  for (std::size_t size = 4; size < whole.size(); ++size) {
    EXPECT_EQ(image_fault(whole.substr(0, size)), "is damaged: the PNG image is cut off") << size;
  }
  EXPECT_NO_THROW(decode(whole + std::string(3, '\0'))) << "padding is no damage";
}

TEST(ImageDecoder, RefusesACutJpeg) {
  const std::string whole = jpeg(64, 64, 77);
  EXPECT_EQ(image_fault(whole.substr(0, whole.size() - 2)),
            "is damaged: the JPEG image is cut off");
  EXPECT_NO_THROW(decode(whole + std::string(3, '\0'))) << "padding is no damage";
}

/// Of 16384 x 16384 pixels; with as many bytes as they would take at least, the data is what lacks.
TEST(ImageDecoder, RefusesMorePixelsThanItsBytesCanHold) {
  EXPECT_THAT(image_fault(huge_png(0)), HasSubstr("bytes cannot hold 268435456 pixels"));
  EXPECT_THROW(size_of_image(bytes_of(huge_png(0))), std::runtime_error);
  EXPECT_EQ(size_of_image(bytes_of(huge_png(40000))).pixels(), 16384U * 16384U);
}

/// A real one that is all the same, which deflate shrinks to a thousandth.
TEST(ImageDecoder, ReadsWhatIsCompressedAsFarAsCanBe) {
  const int side = 4096;
  const DecodedImage image =
      decode(png(side, side, 1, std::vector<std::uint8_t>(std::size_t{side} * side, 0)));
  EXPECT_EQ(image.width, side);
}

TEST(ImageDecoder, RefusesSidesBeyond16384) {
  std::string wide = one_pixel(1, 2, 3);
  wide.replace(16, 4, std::string("\0\0\x40\x01", 4));
  wide.replace(29, 4, "\x46\x3F\x4A\x31");
  EXPECT_THAT(image_fault(wide), HasSubstr("has 16385 x 1 pixels; up to 16384"));
}

}  // namespace
}  // namespace foveola::test
