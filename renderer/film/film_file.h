// Stores films on disk, bit for bit, to continue a render and to merge its parts.
//
// A file is, all numbers little-endian and without gaps: the line "Foveola film 1" and LF; width,
// height, whether sums of squares are kept (0 or 1), and the length of a text in bytes, uint32
// each; that text; the count of pixels, uint64; for each pixel, in ascending order, PixelState's
// number, count and numbered, uint32 each, the sums of red, green and blue, float64 each, and if
// they are kept that of squares, float64; and the SHA-256 of all before it, as 64 hexadecimal
// digits.
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

#include "renderer/base/files/digest.h"
#include "renderer/base/numbers/exact_sum.h"
#include "renderer/film/equirect_film.h"

namespace foveola {

/// All pixels of `film` with numbered samples, in order of their numbers.
std::vector<PixelState> state_of(const EquirectFilm& film);

/// Merges the states of one pixel in several films, whose samples are disjoint. Sums are rounded
/// once, from their exact values, so that the order and grouping of the films do not matter.
class PixelSum {
 public:
  /// Adds one film's state of the pixel.
  void add(const PixelState& state);
  /// Returns the sum and begins anew. Throws Error for more samples than a pixel can have.
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

/// SHA-256, as 64 lower-case hexadecimal digits, of the film's samples since it was cleared.
///
/// The bytes are the film's width and height, 4 bytes each, and then 32 bytes for each pixel with
/// samples, in order of their numbers: the number, y * width + x, and the count of its samples, 4
/// bytes each, and the sums of their red, green and blue, 8 bytes each. Integers are unsigned, sums
/// are IEEE 754 doubles, all little-endian.
///
/// It does not depend on the number of threads, the samples' division into batches, or whether the
/// film stores variances.
std::string film_sha256(const EquirectFilm& film);

/// A film file's data besides the pixels.
struct FilmHeader {
  IVec2 size{0};
  FilmStatistics statistics = FilmStatistics::mean;
  std::string about;  ///< description by the renderer; at most 16 MiB
};

/// The file appears whole or not at all. states: in ascending order. Throws Error if it cannot be
/// written.
void write_film_file(const std::filesystem::path& path, const FilmHeader& header,
                     std::span<const PixelState> states);

/// Reads a film pixel by pixel, so that many can be read in parallel.
class FilmFileReader {
 public:
  /// Throws Error if the file cannot be read or is not a film.
  explicit FilmFileReader(std::filesystem::path path);

  const FilmHeader& header() const { return header_; }
  const std::filesystem::path& path() const { return path_; }

  /// The next pixel; nullopt after the last. Throws Error if the file is damaged: pixels are
  /// verified only once nullopt was returned.
  std::optional<PixelState> next();

 private:
  [[noreturn]] void fail() const;
  /// The next bytes, valid until the next read.
  std::string_view read(std::size_t size);
  void refill();

  std::filesystem::path path_;
  std::ifstream file_;
  Sha256 digest_;
  FilmHeader header_;
  std::uint64_t left_ = 0;             ///< pixels not yet read from the file
  std::string buffer_;                 ///< the last bytes read
  std::size_t used_ = 0;               ///< number of its bytes consumed
  std::optional<std::uint32_t> last_;  ///< the number of the last pixel
  bool is_over_ = false;
};

/// All pixels of an unread reader.
std::vector<PixelState> rest_of(FilmFileReader& reader);

}  // namespace foveola
