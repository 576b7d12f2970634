// Films on disk, bit for bit: so that a render goes on after its time was up, and parts of one that
// were rendered by themselves are put together.
//
// A file is, all numbers little-endian and without gaps: the line "Foveola film 1" and LF;
// width, height, whether sums of squares are kept (0 or 1), and the length of a text in bytes,
// uint32 each; that text; the count of pixels, uint64; for each pixel, in ascending order,
// PixelState's number, count and numbered, uint32 each, the sums of red, green and blue, float64
// each, and if they are kept that of squares, float64; and the SHA-256 of all before it, as 64
// hexadecimal digits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/base/exact_sum.h"
#include "renderer/base/files/digest.h"
#include "renderer/film/equirect_film.h"

namespace foveola {

/// Every pixel of `film` that samples were numbered in, in the order of their numbers.
std::vector<PixelState> state_of(const EquirectFilm& film);

/// Puts the same pixel of several films together: what falls in none is in none of them. Sums are
/// rounded once, from their exact values, so that neither their order nor how they are grouped
/// matters as long as each film is given by itself.
class PixelSum {
 public:
  /// All of one pixel.
  void add(const PixelState& state);
  /// The sum, and begins anew. Throws Error for more samples than a pixel can have.
  PixelState take();

 private:
  std::uint32_t pixel_ = 0;
  std::uint64_t count_ = 0;
  std::uint64_t numbered_ = 0;
  ExactSum red_;
  ExactSum green_;
  ExactSum blue_;
  ExactSum squares_;
};

/// The SHA-256, as 64 lower-case hexadecimal digits, of what fell on the film since it was cleared.
///
/// The bytes are the film's width and height, 4 bytes each, and then 32 bytes for each pixel with
/// samples, in the order of their numbers: the number, y * width + x, and the count of its samples,
/// 4 bytes each, and the sums of their red, green and blue, 8 bytes each. Integers are without
/// sign, sums are IEEE 754's double precision, all of them little-endian.
///
/// Neither the number of threads nor how samples were cut into batches changes it, nor whether the
/// film keeps variances.
std::string film_sha256(const EquirectFilm& film);

/// What a file says of its film beside the pixels.
struct FilmHeader {
  IVec2 size{0};
  FilmStatistics statistics = FilmStatistics::mean;
  std::string about;  ///< what was rendered, by whoever rendered it; at most 16 MiB
};

/// The file appears whole or not at all. states: in ascending order. Throws Error if it cannot be
/// written.
void write_film_file(const std::filesystem::path& path, const FilmHeader& header,
                     std::span<const PixelState> states);

/// Reads a film pixel by pixel, so that many can be read side by side.
class FilmFileReader {
 public:
  /// Throws Error if the file cannot be read or is none.
  explicit FilmFileReader(std::filesystem::path path);

  const FilmHeader& header() const { return header_; }
  const std::filesystem::path& path() const { return path_; }

  /// The next pixel; empty after the last one. Throws Error if the file is damaged: what was read
  /// is only to be believed once this returned nothing.
  std::optional<PixelState> next();

 private:
  [[noreturn]] void fail() const;
  /// Takes the next bytes, which stay until others are read.
  std::string_view read(std::size_t size);
  void refill();

  std::filesystem::path path_;
  std::ifstream file_;
  Sha256 digest_;
  FilmHeader header_;
  std::uint64_t left_ = 0;             ///< pixels that were not read from the file
  std::string buffer_;                 ///< what was read last
  std::size_t used_ = 0;               ///< bytes of it that were taken
  std::optional<std::uint32_t> last_;  ///< the number of the last pixel
  bool is_over_ = false;
};

/// All pixels of a reader that has not been read from.
std::vector<PixelState> rest_of(FilmFileReader& reader);

}  // namespace foveola
