#include "renderer/film/film_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/files/little_endian.h"

namespace foveola {
namespace {

/// A pixel for hashing: its bytes in memory are those documented in the header.
struct HashedPixel {
  std::uint32_t number;
  std::uint32_t count;
  DVec3 sum;
};
static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(HashedPixel) == 32);

/// Pixels hashed at a time.
constexpr std::size_t pixels_at_once = 4096;

constexpr std::string_view first_line = "Foveola film 1\n";
constexpr std::uint32_t longest_text = 16 << 20;
constexpr std::size_t digest_digits = 64;
/// Pixels read at a time.
constexpr std::size_t pixels_read_together = 4096;

std::size_t bytes_of_pixel(FilmStatistics statistics) {
  return 3 * sizeof(std::uint32_t) + (statistics == FilmStatistics::mean ? 3 : 4) * sizeof(double);
}

void append_state(std::string& bytes, const PixelState& state, FilmStatistics statistics) {
  append(bytes, state.pixel);
  append(bytes, state.count);
  append(bytes, state.numbered);
  append(bytes, state.sum.r);
  append(bytes, state.sum.g);
  append(bytes, state.sum.b);
  if (statistics == FilmStatistics::mean_and_variance) {
    append(bytes, state.squares);
  }
}

/// Removes a pixel from the front of `bytes`, which holds one.
PixelState take_state(std::string_view& bytes, FilmStatistics statistics) {
  PixelState state;
  state.pixel = take<std::uint32_t>(bytes);
  state.count = take<std::uint32_t>(bytes);
  state.numbered = take<std::uint32_t>(bytes);
  for (int channel = 0; channel < 3; ++channel) {
    state.sum[channel] = take_double(bytes);
  }
  if (statistics == FilmStatistics::mean_and_variance) {
    state.squares = take_double(bytes);
  }
  return state;
}

/// Samples are finite floats, fewer than 2^32 per pixel. Sums of many films are finite, too.
bool is_possible(const PixelState& state, const IVec2& size) {
  constexpr double largest_sum = 0x1p160;
  constexpr double largest_squares = 0x1p290;
  const auto is_sum = [](double sum) { return std::abs(sum) <= largest_sum; };
  return state.pixel < static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y) &&
         state.count <= state.numbered && state.numbered > 0 && is_sum(state.sum.r) &&
         is_sum(state.sum.g) && is_sum(state.sum.b) && state.squares >= 0.0 &&
         state.squares <= largest_squares;
}

/// A file whose digest is computed during writing.
class DigestedFile {
 public:
  explicit DigestedFile(const std::filesystem::path& path) : file_(path, std::ios::binary) {}

  void write(std::string_view bytes) {
    digest_.update(std::as_bytes(std::span(bytes)));
    file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }

  /// Returns whether all of it, and the digest, were written.
  bool finish() {
    file_ << digest_.hex();
    file_.close();
    return !file_.fail();
  }

 private:
  std::ofstream file_;
  Sha256 digest_;
};

}  // namespace

std::vector<PixelState> state_of(const EquirectFilm& film) {
  std::vector<PixelState> states;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      if (const std::optional<PixelState> state = film.pixel_state(x, y)) {
        states.push_back(*state);
      }
    }
  }
  return states;
}

void PixelSum::add(const PixelState& state) {
  pixel_ = state.pixel;
  count_ += state.count;
  numbered_ += state.numbered;
  red_.add(state.sum.r);
  green_.add(state.sum.g);
  blue_.add(state.sum.b);
  squares_.add(state.squares);
}

PixelState PixelSum::take() {
  if (numbered_ > std::numeric_limits<std::uint32_t>::max()) {
    throw Error("films", "have more samples in a pixel than one image can hold", "merge fewer");
  }
  const PixelState state{.pixel = pixel_,
                         .count = static_cast<std::uint32_t>(count_),
                         .numbered = static_cast<std::uint32_t>(numbered_),
                         .sum = {red_.rounded(), green_.rounded(), blue_.rounded()},
                         .squares = squares_.rounded()};
  count_ = 0;
  numbered_ = 0;
  for (ExactSum* const sum : {&red_, &green_, &blue_, &squares_}) {
    sum->clear();  // keeps its memory for the next of millions of pixels
  }
  return state;
}

std::string film_sha256(const EquirectFilm& film) {
  Sha256 digest;
  const std::array<std::uint32_t, 2> size = {static_cast<std::uint32_t>(film.width()),
                                             static_cast<std::uint32_t>(film.height())};
  digest.update(std::as_bytes(std::span(size)));
  std::vector<HashedPixel> pixels;
  pixels.reserve(pixels_at_once);
  const auto hash_pixels = [&] {
    digest.update(std::as_bytes(std::span(pixels)));
    pixels.clear();
  };
  film.for_each_sampled_pixel([&](const IVec2& place, const FilmTile::Pixel& pixel) {
    pixels.push_back({.number = static_cast<std::uint32_t>(place.y) * size[0] +
                                static_cast<std::uint32_t>(place.x),
                      .count = pixel.count,
                      .sum = pixel.sum});
    if (pixels.size() == pixels_at_once) {
      hash_pixels();
    }
  });
  hash_pixels();
  return digest.hex();
}

void write_film_file(const std::filesystem::path& path, const FilmHeader& header,
                     std::span<const PixelState> states) {
  replace_file(path, [&](const std::filesystem::path& temporary) {
    DigestedFile file(temporary);
    std::string bytes(first_line);
    append(bytes, static_cast<std::uint32_t>(header.size.x));
    append(bytes, static_cast<std::uint32_t>(header.size.y));
    append(bytes, std::uint32_t{header.statistics == FilmStatistics::mean_and_variance});
    append(bytes, static_cast<std::uint32_t>(header.about.size()));
    bytes += header.about;
    append(bytes, std::uint64_t{states.size()});
    for (std::size_t i = 0; i < states.size(); ++i) {
      append_state(bytes, states[i], header.statistics);
      if (i % pixels_read_together == 0) {
        file.write(bytes);
        bytes.clear();
      }
    }
    file.write(bytes);
    if (!file.finish()) {
      throw Error(path.string(), "cannot be written", "check that there is room for it");
    }
  });
}

FilmFileReader::FilmFileReader(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code failure;
  const std::uintmax_t bytes = std::filesystem::file_size(path_, failure);
  if (!failure) {  // a regular file, which never blocks
    file_.open(path_, std::ios::binary);
  }
  if (failure || !file_) {
    throw Error(path_.string(), "cannot be read", "check the path");
  }
  if (bytes < first_line.size()) {
    fail();
  }
  if (read(first_line.size()) != first_line) {
    throw Error(path_.string(), "is not a film that this program reads",
                "name one that foveola render has written");
  }
  std::string_view numbers = read(4 * sizeof(std::uint32_t));
  const auto width = take<std::uint32_t>(numbers);
  const auto height = take<std::uint32_t>(numbers);
  const auto squares = take<std::uint32_t>(numbers);
  const auto length = take<std::uint32_t>(numbers);
  constexpr std::uint32_t most = EquirectFilm::largest_side;
  if (width < 1 || width > most || height < 1 || height > most || squares > 1 ||
      length > longest_text || length > bytes) {
    fail();
  }
  header_.size = IVec2(width, height);
  header_.statistics = squares == 1 ? FilmStatistics::mean_and_variance : FilmStatistics::mean;
  header_.about = read(length);
  std::string_view count = read(sizeof(std::uint64_t));
  left_ = take<std::uint64_t>(count);
  const std::uint64_t pixels = std::uint64_t{width} * height;
  const std::uint64_t before = first_line.size() + 4 * sizeof(std::uint32_t) + length +
                               sizeof(std::uint64_t) + digest_digits;
  if (left_ > pixels || bytes != before + left_ * bytes_of_pixel(header_.statistics)) {
    fail();
  }
}

void FilmFileReader::fail() const {
  throw Error(path_.string(), "is damaged", "render this part again");
}

std::string_view FilmFileReader::read(std::size_t size) {
  buffer_.resize(size);
  file_.read(buffer_.data(), static_cast<std::streamsize>(size));
  if (!file_) {
    fail();
  }
  digest_.update(std::as_bytes(std::span(buffer_)));
  used_ = size;
  return buffer_;
}

void FilmFileReader::refill() {
  const auto pixels =
      static_cast<std::size_t>(std::min<std::uint64_t>(left_, pixels_read_together));
  read(pixels * bytes_of_pixel(header_.statistics));
  used_ = 0;
  left_ -= pixels;
}

std::optional<PixelState> FilmFileReader::next() {
  if (used_ == buffer_.size() && left_ > 0) {
    refill();
  }
  if (used_ == buffer_.size()) {
    if (!std::exchange(is_over_, true)) {
      std::string digits(digest_digits, ' ');
      file_.read(digits.data(), static_cast<std::streamsize>(digits.size()));
      if (!file_ || digits != digest_.hex()) {
        fail();
      }
    }
    return std::nullopt;
  }
  std::string_view unused = std::string_view(buffer_).substr(used_);
  const PixelState state = take_state(unused, header_.statistics);
  used_ = buffer_.size() - unused.size();
  if (!is_possible(state, header_.size) || (last_ && state.pixel <= *last_)) {
    fail();
  }
  last_ = state.pixel;
  return state;
}

std::vector<PixelState> rest_of(FilmFileReader& reader) {
  std::vector<PixelState> states;
  while (const std::optional<PixelState> state = reader.next()) {
    states.push_back(*state);
  }
  return states;
}

}  // namespace foveola
