#include "renderer/film/film_file.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/base/numbers/random.h"
#include "tests/matchers.h"
#include "tests/renderer/film/film_samples.h"
#include "tests/temporary_folder.h"

namespace foveola {
namespace {

using test::TemporaryFolder;

constexpr FilmStatistics with_squares = FilmStatistics::mean_and_variance;

std::vector<PixelState> random_states(int count) {
  Pcg32 random(5);
  std::vector<PixelState> states;
  for (int i = 0; i < count; ++i) {
    states.push_back({.pixel = 3U * static_cast<std::uint32_t>(i) + random.next() % 3U,
                      .count = random.next() % 1000U,
                      .numbered = 1000U + random.next() % 1000U,
                      .sum = {random.uniform(), 1e30 * random.uniform(), -random.uniform()},
                      .squares = random.uniform()});
  }
  return states;
}

class FilmFile : public testing::Test {
 protected:
  void expect_refused(const std::string& bytes) const {
    EXPECT_THROW(
        {
          FilmFileReader reader(folder_.write("other.film", bytes));
          rest_of(reader);
        },
        Error);
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "a.film";
};

TEST_F(FilmFile, BringsPixelsBackBitForBit) {
  for (const FilmStatistics statistics : {FilmStatistics::mean, with_squares}) {
    for (const int count : {0, 1, 4096, 4097, 10'000}) {
      const std::vector<PixelState> states = random_states(count);
      write_film_file(path_, {.size = {300, 200}, .statistics = statistics, .about = "{\"a\":1}"},
                      states);
      FilmFileReader reader(path_);
      EXPECT_EQ(reader.header().size, IVec2(300, 200));
      EXPECT_EQ(reader.header().statistics, statistics);
      EXPECT_EQ(reader.header().about, "{\"a\":1}");
      const std::vector<PixelState> back = rest_of(reader);
      ASSERT_EQ(back.size(), states.size());
      for (std::size_t i = 0; i < back.size(); ++i) {
        ASSERT_EQ(back[i].pixel, states[i].pixel);
        ASSERT_EQ(back[i].count, states[i].count);
        ASSERT_EQ(back[i].numbered, states[i].numbered);
        ASSERT_EQ(back[i].sum, states[i].sum);
        ASSERT_EQ(back[i].squares, statistics == with_squares ? states[i].squares : 0.0);
      }
    }
  }
}

TEST_F(FilmFile, IsRefusedWhateverByteIsAnother) {
  write_film_file(path_, {.size = {30, 20}, .statistics = with_squares, .about = "{}"},
                  random_states(3));
  const std::string bytes = read_file(path_);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::string other = bytes;
    other[i] = static_cast<char>(other[i] ^ 0x40);
    expect_refused(other);
  }
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    expect_refused(bytes.substr(0, length));
  }
  expect_refused(bytes + ' ');
}

TEST_F(FilmFile, IsRefusedForSumsThatNoSamplesHave) {
  const auto expect_read = [&](const PixelState& state, bool is_possible) {
    write_film_file(path_, {.size = {3, 2}, .statistics = with_squares}, {{state}});
    FilmFileReader reader(path_);
    if (is_possible) {
      EXPECT_EQ(rest_of(reader).size(), 1U);
    } else {
      EXPECT_THAT([&] { rest_of(reader); }, ThrowsMessage<Error>(HasSubstr("is damaged")));
    }
  };
  constexpr double largest = std::numeric_limits<float>::max();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const PixelState state{
      .pixel = 5, .count = 1, .numbered = 1, .sum = DVec3(largest), .squares = largest * largest};
  expect_read(state, true);
  for (const double impossible : {1e100, -1e100, infinity, none}) {
    PixelState other = state;
    other.sum.g = impossible;
    expect_read(other, false);
  }
  for (const double impossible : {-1.0, 1e100, infinity, none}) {
    PixelState other = state;
    other.squares = impossible;
    expect_read(other, false);
  }
  PixelState other = state;
  other.count = 2;
  expect_read(other, false);
  other = state;
  other.pixel = 6;
  expect_read(other, false);
}

TEST_F(FilmFile, HasEachPixelOnceAndInOrder) {
  for (const std::uint32_t second : {4U, 5U}) {
    std::vector<PixelState> states(2, {.pixel = 5, .count = 1, .numbered = 1});
    states[1].pixel = second;
    write_film_file(path_, {.size = {3, 2}}, states);
    FilmFileReader reader(path_);
    EXPECT_THAT([&] { rest_of(reader); }, ThrowsMessage<Error>(HasSubstr("is damaged"))) << second;
  }
}

TEST_F(FilmFile, MustBeAFilmThatIsThere) {
  EXPECT_THAT([&] { FilmFileReader(folder_ / "none.film"); },
              ThrowsMessage<Error>(HasSubstr("none.film: cannot be read")));
  EXPECT_THAT([&] { FilmFileReader(folder_.path()); },
              ThrowsMessage<Error>(HasSubstr("cannot be read")));
  ::mkfifo((folder_ / "pipe.film").c_str(), 0600);
  EXPECT_THAT([&] { FilmFileReader(folder_ / "pipe.film"); },
              ThrowsMessage<Error>(HasSubstr("cannot be read")));
  EXPECT_THAT([&] { FilmFileReader(folder_.write("b.film", "a text that is long enough")); },
              ThrowsMessage<Error>(HasSubstr("is not a film that this program reads")));
  EXPECT_THROW(write_film_file(folder_ / "none/a.film", {.size = {3, 2}}, {}), Error);
}

constexpr FilmStatistics keeps_squares = FilmStatistics::mean_and_variance;

TEST(FilmState, IsGoneOnWithAsIfNothingHadBeen) {
  const Workers workers(2);
  EquirectFilm whole(100, 50, keeps_squares);
  add_samples(sobol_samples(0, 3000), whole, workers);
  EquirectFilm restored(100, 50, keeps_squares);
  restored.restore(state_of(whole), workers);
  EXPECT_EQ(film_sha256(restored), film_sha256(whole));
  EXPECT_EQ(restored.total_samples(), whole.total_samples());
  EXPECT_GT(restored.revision(), 0U);

  for (EquirectFilm* const film : {&whole, &restored}) {
    add_samples(sobol_samples(3000, 5000), *film, workers);
  }
  EXPECT_EQ(film_sha256(restored), film_sha256(whole));
  EXPECT_EQ(restored.resolve().variances, whole.resolve().variances);
  for (int level = 0; level < whole.levels(); ++level) {
    for (int y = 0; y < whole.height(level); ++y) {
      for (int x = 0; x < whole.width(level); ++x) {
        ASSERT_EQ(restored.cell(level, x, y).weight, whole.cell(level, x, y).weight);
        ASSERT_EQ(restored.cell(level, x, y).color, whole.cell(level, x, y).color);
      }
    }
  }
}

TEST(FilmState, RemembersNumbersOfSamplesThatWereDropped) {
  const Workers workers(1);
  EquirectFilm film(100, 50);
  NumberedBatch batch;
  film.number(in_pixel(7, 9, film, 2), batch, workers);
  const Rgb infinite(std::numeric_limits<float>::infinity());
  film.add(batch, std::vector<Rgb>{infinite, infinite}, workers);
  EXPECT_EQ(state_of(film).size(), 1U);
  EquirectFilm restored(100, 50);
  restored.restore(state_of(film), workers);
  EXPECT_EQ(restored.sample_count(7, 9), 0U);
  restored.number(in_pixel(7, 9, restored, 1), batch, workers);
  EXPECT_EQ(batch.jobs.front().sample_number, 2U);
}

TEST(PixelSum, IsTheSameInAnyOrder) {
  const std::vector<PixelState> parts = {
      {.pixel = 3, .count = 1, .numbered = 1, .sum = {1e16, 0.1, 1.0}, .squares = 1.0},
      {.pixel = 3, .count = 2, .numbered = 3, .sum = {1.0, 0.2, 1.0}, .squares = 0x1p-53},
      {.pixel = 3, .count = 4, .numbered = 4, .sum = {-1e16, 0.3, 1.0}, .squares = 0x1p-106}};
  PixelSum sum;
  for (const std::vector<int>& order : {std::vector{0, 1, 2}, {2, 1, 0}, {1, 0, 2}}) {
    for (const int part : order) {
      sum.add(parts[static_cast<std::size_t>(part)]);
    }
    const PixelState all = sum.take();
    EXPECT_EQ(all.pixel, 3U);
    EXPECT_EQ(all.count, 7U);
    EXPECT_EQ(all.numbered, 8U);
    EXPECT_EQ(all.sum, DVec3(1.0, 0.6, 3.0));
    EXPECT_EQ(all.squares, 1.0 + 0x1p-52);
  }
}

TEST(PixelSum, CannotHoldMoreSamplesThanAPixel) {
  PixelSum sum;
  sum.add({.count = 1, .numbered = 4'000'000'000U});
  sum.add({.count = 1, .numbered = 4'000'000'000U});
  EXPECT_THROW(sum.take(), Error);
}

}  // namespace

}  // namespace foveola
