#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/film/film_file.h"
#include "tests/renderer/film/film_samples.h"

namespace foveola {
namespace {

void add(const std::vector<ViewSample>& samples, const std::vector<Rgb>& colors,
         EquirectFilm& film) {
  const Workers workers(2);
  NumberedBatch batch;
  film.number(samples, batch, workers);
  film.add(batch, colors, workers);
}

// The expected values are Python's: hashlib.sha256(b).hexdigest() with
// b = struct.pack("<II", width, height), to which struct.pack("<IIddd", number, count, r, g, b) was
// added for each pixel.

TEST(FilmHash, IsOfTheSizeAloneWithoutSamples) {
  EXPECT_EQ(film_sha256(EquirectFilm(100, 50)),
            "a89366fd9d1cad1f68a29ecc1ba91511689dbd017d61b8e943bee2ae3a1db214");
}

TEST(FilmHash, IsOfTheBytesThatItsHeaderPromises) {
  EquirectFilm film(100, 50);
  add(in_pixel(99, 49, film, 3), {{1, 2, 3}, {2, 4, 6}, {6, 0, 0}}, film);
  add(in_pixel(0, 1, film, 1), {{-2, 0, 0x1p-10F}}, film);
  add(in_pixel(40, 0, film, 1), {{0.5F, 0.25F, 0.125F}}, film);
  EXPECT_EQ(film_sha256(film), "259eb305ce3176b466735fca830a73b30b756173f456990ac52a300cb87eec27");
}

TEST(FilmHash, CountsEveryPixelOfManyTiles) {
  EquirectFilm film(300, 20);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 300; ++x) {
      add(in_pixel(x, y, film, 1), {{x, y, 1}}, film);
    }
  }
  EXPECT_EQ(film_sha256(film), "947eb5d7746411dc11978fb2813ebaf031cdc53dfa4c931f4dcda87ea3743815");
}

TEST(FilmHash, DistinguishesFilmsThatDifferInOneBit) {
  const auto hash = [](const Rgb& second) {
    EquirectFilm film(100, 50);
    add(in_pixel(5, 5, film, 2), {{1, 1, 1}, second}, film);
    return film_sha256(film);
  };
  EXPECT_NE(hash({1, 1, 1}), hash({1, 1, 0x1.000002p0F}));
}

TEST(FilmHash, ForgetsWhatWasClearedAndWhatWasDropped) {
  EquirectFilm film(100, 50);
  const std::string empty = film_sha256(film);
  add(in_pixel(5, 5, film, 1), {Rgb(1.0F)}, film);
  EXPECT_NE(film_sha256(film), empty);
  film.clear();
  EXPECT_EQ(film_sha256(film), empty);
  add(in_pixel(5, 5, film, 1), {Rgb(std::numeric_limits<float>::quiet_NaN())}, film);
  EXPECT_EQ(film_sha256(film), empty);
}

}  // namespace
}  // namespace foveola
