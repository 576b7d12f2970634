#include "renderer/film/film_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <system_error>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace foveola {
namespace {

constexpr std::string_view first_line = "Foveola film 1\n";
constexpr std::uint32_t longest_text = 16 << 20;
constexpr std::size_t digest_digits = 64;
/// Pixels for which the file is asked once.
constexpr std::size_t pixels_read_together = 4096;

static_assert(std::endian::native == std::endian::little,
              "numbers are written as they lie in memory");

std::size_t bytes_of_pixel(FilmStatistics statistics) {
  return 3 * sizeof(std::uint32_t) + (statistics == FilmStatistics::mean ? 3 : 4) * sizeof(double);
}

template <typename Number>
void append(std::vector<std::byte>& bytes, Number number) {
  const auto raw = std::bit_cast<std::array<std::byte, sizeof(Number)>>(number);
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

template <typename Number>
Number taken(const std::byte*& bytes) {
  std::array<std::byte, sizeof(Number)> raw;
  std::memcpy(raw.data(), bytes, raw.size());
  bytes += raw.size();
  return std::bit_cast<Number>(raw);
}

void append(std::vector<std::byte>& bytes, const PixelState& state, FilmStatistics statistics) {
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

PixelState state_at(const std::byte* bytes, FilmStatistics statistics) {
  PixelState state;
  state.pixel = taken<std::uint32_t>(bytes);
  state.count = taken<std::uint32_t>(bytes);
  state.numbered = taken<std::uint32_t>(bytes);
  for (int channel = 0; channel < 3; ++channel) {
    state.sum[channel] = taken<double>(bytes);
  }
  if (statistics == FilmStatistics::mean_and_variance) {
    state.squares = taken<double>(bytes);
  }
  return state;
}

bool is_possible(const PixelState& state, const IVec2& size) {
  return state.pixel < static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y) &&
         state.count <= state.numbered && state.numbered > 0 && std::isfinite(state.sum.r) &&
         std::isfinite(state.sum.g) && std::isfinite(state.sum.b) && std::isfinite(state.squares);
}

/// A file whose digest is made while it is written.
class DigestedFile {
 public:
  explicit DigestedFile(const std::filesystem::path& path) : file_(path, std::ios::binary) {}

  void write(std::span<const std::byte> bytes) {
    digest_.update(bytes);
    file_.write(reinterpret_cast<const char*>(bytes.data()),
                static_cast<std::streamsize>(bytes.size()));
  }

  /// Whether all of it, and the digest, could be written.
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

void write_film_file(const std::filesystem::path& path, const FilmHeader& header,
                     std::span<const PixelState> states) {
  replace_file(path, [&](const std::filesystem::path& temporary) {
    DigestedFile file(temporary);
    file.write(std::as_bytes(std::span(first_line)));
    std::vector<std::byte> bytes;
    append(bytes, static_cast<std::uint32_t>(header.size.x));
    append(bytes, static_cast<std::uint32_t>(header.size.y));
    append(bytes, std::uint32_t{header.statistics == FilmStatistics::mean_and_variance});
    append(bytes, static_cast<std::uint32_t>(header.about.size()));
    file.write(bytes);
    file.write(std::as_bytes(std::span(header.about)));
    bytes.clear();
    append(bytes, std::uint64_t{states.size()});
    for (std::size_t i = 0; i < states.size(); ++i) {
      append(bytes, states[i], header.statistics);
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
  if (!failure) {  // a regular file, which does not wait for anybody
    file_.open(path_, std::ios::binary);
  }
  if (failure || !file_) {
    throw Error(path_.string(), "cannot be read", "check the path");
  }
  std::array<char, first_line.size()> line{};
  if (bytes < line.size()) {
    fail();
  }
  read(std::as_writable_bytes(std::span(line)));
  if (std::string_view(line.data(), line.size()) != first_line) {
    throw Error(path_.string(), "is no film that this program knows",
                "name one that foveola render has written");
  }
  const auto width = read_number<std::uint32_t>();
  const auto height = read_number<std::uint32_t>();
  const auto squares = read_number<std::uint32_t>();
  const auto length = read_number<std::uint32_t>();
  constexpr std::uint32_t most = EquirectFilm::largest_side;
  if (width < 1 || width > most || height < 1 || height > most || squares > 1 ||
      length > longest_text || length > bytes) {
    fail();
  }
  header_.size = IVec2(width, height);
  header_.statistics = squares == 1 ? FilmStatistics::mean_and_variance : FilmStatistics::mean;
  header_.about.resize(length);
  read(std::as_writable_bytes(std::span(header_.about)));
  left_ = read_number<std::uint64_t>();
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

void FilmFileReader::read(std::span<std::byte> bytes) {
  file_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file_) {
    fail();
  }
  digest_.update(bytes);
}

template <typename Number>
Number FilmFileReader::read_number() {
  std::array<std::byte, sizeof(Number)> raw;
  read(raw);
  return std::bit_cast<Number>(raw);
}

void FilmFileReader::refill() {
  const auto pixels =
      static_cast<std::size_t>(std::min<std::uint64_t>(left_, pixels_read_together));
  buffer_.resize(pixels * bytes_of_pixel(header_.statistics));
  used_ = 0;
  left_ -= pixels;
  read(buffer_);
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
  const PixelState state = state_at(&buffer_[used_], header_.statistics);
  used_ += bytes_of_pixel(header_.statistics);
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
