#include "renderer/window/drawing/film_mirror.h"

#include <vector>

#include <gtest/gtest.h>

#include "renderer/base/numbers/random.h"
#include "renderer/film/equirect_film.h"
#include "renderer/view/equirect.h"
#include "tests/renderer/window/patterned_film.h"

namespace foveola {
namespace {

/// A copy of a film's pyramid, as a graphics card has it.
class CopyOnTheProcessor {
 public:
  explicit CopyOnTheProcessor(const PyramidAtlas& atlas)
      : atlas_(atlas), cells_(static_cast<std::size_t>(atlas.size().x) * atlas.size().y) {}

  void apply(const FilmUpdate& update) {
    for (const AtlasRectangle& rectangle : update) {
      for (int y = rectangle.y; y < rectangle.y + rectangle.height; ++y) {
        for (int x = rectangle.x; x < rectangle.x + rectangle.width; ++x) {
          at({x, y}) = rectangle.value;
        }
      }
    }
  }

  PremultipliedTexel cell(int level, const IVec2& place) {
    return at(atlas_.levels()[static_cast<std::size_t>(level)].origin + place);
  }

 private:
  PremultipliedTexel& at(const IVec2& place) {
    return cells_.at(static_cast<std::size_t>(place.y) * atlas_.size().x + place.x);
  }

  PyramidAtlas atlas_;
  std::vector<PremultipliedTexel> cells_;
};

class FilmMirrorTest : public ::testing::TestWithParam<IVec2> {
 protected:
  /// Adds samples of random colours at random places.
  void add(int count) {
    std::vector<Vec2> images(static_cast<std::size_t>(count));
    std::vector<Rgb> radiance(images.size());
    for (std::size_t i = 0; i < images.size(); ++i) {
      const auto u = static_cast<float>(random_.uniform());
      images[i] = {u, static_cast<float>(random_.uniform())};
      radiance[i] = Rgb(static_cast<float>(random_.uniform()));
    }
    test::add_samples(film_, images, radiance, workers_);
  }

  FilmUpdate collect(const Viewport& viewport, int levels) {
    FilmUpdate update = mirror_.collect(film_, std::span(&viewport, 1), levels);
    copy_.apply(update);
    return update;
  }

  /// Every cell that a bilinear look at any of a grid of the viewport's directions touches.
  void expect_up_to_date(const Viewport& viewport, int levels) {
    constexpr int steps = 40;
    for (int i = 0; i <= steps * steps; ++i) {
      const Vec2 plane = Vec2(i % steps, i / steps) / static_cast<float>(steps);
      const Vec2 image = equirect_from_direction(viewport.direction(plane));
      for (int level = 0; level < levels; ++level) {
        const IVec2 size(film_.width(level), film_.height(level));
        const Vec2 place =
            image * Vec2(film_.width(), film_.height()) / static_cast<float>(1 << level) - 0.5F;
        for (const IVec2 corner : {IVec2(0, 0), IVec2(1, 0), IVec2(0, 1), IVec2(1, 1)}) {
          IVec2 at = IVec2(glm::floor(place)) + corner;
          at.x = (at.x + size.x) % size.x;
          if (at.y < 0 || at.y >= size.y) {
            continue;
          }
          const PremultipliedTexel expected = film_.cell(level, at.x, at.y);
          const PremultipliedTexel actual = copy_.cell(level, at);
          ASSERT_EQ(actual.weight, expected.weight) << level << ' ' << at.x << ' ' << at.y;
          ASSERT_EQ(actual.color, expected.color) << level << ' ' << at.x << ' ' << at.y;
        }
      }
    }
  }

  static Viewport looking(double azimuth_deg, double elevation_deg) {
    return {head_orientation({radians(azimuth_deg), radians(elevation_deg)}), radians(80.0),
            radians(70.0)};
  }

  Workers workers_{2};
  Pcg32 random_{7, 1};
  EquirectFilm film_{GetParam().x, GetParam().y};
  FilmMirror mirror_{film_};
  CopyOnTheProcessor copy_{mirror_.atlas()};
};

TEST_P(FilmMirrorTest, FollowsTheFilmWhereItIsSeen) {
  for (const Viewport& viewport : {looking(0, 0), looking(0, 0), looking(30, 10), looking(180, -5),
                                   looking(-170, 60), looking(90, 88), looking(0, -80)}) {
    add(300);
    collect(viewport, 3);
    expect_up_to_date(viewport, 3);
  }
}

TEST_P(FilmMirrorTest, ForgetsWhatWasCleared) {
  add(5000);
  collect(looking(0, 0), 4);
  film_.clear();
  collect(looking(0, 0), 4);
  expect_up_to_date(looking(0, 0), 4);
  add(100);
  // What was out of view when the film was cleared is cleared as it comes into view.
  collect(looking(120, 0), 4);
  expect_up_to_date(looking(120, 0), 4);
  collect(looking(0, 0), 4);
  expect_up_to_date(looking(0, 0), 4);
}

TEST_P(FilmMirrorTest, BringsMoreLevelsWhenTheyAreAskedFor) {
  add(2000);
  collect(looking(0, 0), 2);
  add(100);
  collect(looking(0, 0), 5);
  expect_up_to_date(looking(0, 0), 5);
  add(100);
  collect(looking(0, 0), 1);
  add(100);
  collect(looking(0, 0), film_.levels());
  expect_up_to_date(looking(0, 0), film_.levels());
}

TEST_P(FilmMirrorTest, WritesNothingTwice) {
  add(2000);
  EXPECT_FALSE(collect(looking(0, 0), 3).empty());
  EXPECT_TRUE(collect(looking(0, 0), 3).empty());
}

INSTANTIATE_TEST_SUITE_P(Sizes, FilmMirrorTest,
                         ::testing::Values(IVec2(512, 256), IVec2(300, 150), IVec2(64, 32)));

TEST(FilmMirrorCost, OneSampleIsAFewCells) {
  EquirectFilm film(4096, 2048);
  const Workers workers(1);
  FilmMirror mirror(film);
  const Viewport viewport(head_orientation({}), radians(90.0), radians(90.0));
  test::add_samples(film, {Vec2(0.5F, 0.5F)}, {Rgb(1.0F)}, workers);
  EXPECT_LE(mirror.collect(film, std::span(&viewport, 1), 3).size(), 3U);
}

TEST(FilmMirrorCost, WhatIsOutOfViewIsNotCopied) {
  EquirectFilm film(4096, 2048);
  const Workers workers(1);
  FilmMirror mirror(film);
  const Viewport viewport(head_orientation({}), radians(90.0), radians(90.0));
  test::add_samples(film, {Vec2(0.0F, 0.5F)}, {Rgb(1.0F)}, workers);
  EXPECT_TRUE(mirror.collect(film, std::span(&viewport, 1), 3).empty());
}

/// The largest level that viewport_image's rule gives any pixel of the view, by looking at each.
TEST(LevelsShown, CoverTheRule) {
  const RadialLens barrel{.k1 = 0.3F, .k2 = 0.2F};
  for (const RadialLens& lens : {RadialLens{}, barrel}) {
    for (const int pixels : {16, 100, 700}) {
      const Viewport viewport(head_orientation({}), radians(100.0), radians(80.0), lens);
      double coarsest = 0.0;
      for (int y = 0; y < pixels; ++y) {
        for (int x = 0; x < pixels; ++x) {
          const Vec2 plane = (Vec2(x, y) + 0.5F) / static_cast<float>(pixels);
          const double side_rad = std::sqrt(viewport.sr_per_area(plane) / (pixels * pixels));
          coarsest = std::max(coarsest, std::log2(side_rad * 1024 / 3.14159265358979));
        }
      }
      const int levels = levels_shown(viewport, {pixels, pixels}, 1024);
      EXPECT_GE(levels, 2 + static_cast<int>(coarsest));
      EXPECT_LE(levels, 3 + static_cast<int>(coarsest));
    }
  }
}

TEST(PyramidAtlasTest, LevelsAreTheFilms) {
  for (const IVec2 size : {IVec2(64, 32), IVec2(100, 50), IVec2(1, 1), IVec2(7, 65)}) {
    const EquirectFilm film(size.x, size.y);
    const PyramidAtlas atlas(size.x, size.y);
    ASSERT_EQ(static_cast<int>(atlas.levels().size()), film.levels()) << size.x << 'x' << size.y;
    for (int level = 0; level < film.levels(); ++level) {
      EXPECT_EQ(atlas.levels()[level].size, IVec2(film.width(level), film.height(level)));
    }
  }
}

TEST(PyramidAtlasTest, LevelsLieApartAndInside) {
  for (const IVec2 size : {IVec2(64, 32), IVec2(100, 50), IVec2(3, 1), IVec2(7, 65)}) {
    const PyramidAtlas atlas(size.x, size.y);
    std::vector<int> uses(static_cast<std::size_t>(atlas.size().x) * atlas.size().y);
    for (const PyramidAtlas::Level& level : atlas.levels()) {
      for (int y = 0; y < level.size.y; ++y) {
        for (int x = 0; x < level.size.x; ++x) {
          const IVec2 at = level.origin + IVec2(x, y);
          ASSERT_LT(at.x, atlas.size().x);
          ASSERT_LT(at.y, atlas.size().y);
          EXPECT_EQ(++uses[static_cast<std::size_t>(at.y) * atlas.size().x + at.x], 1);
        }
      }
    }
  }
}

TEST(PyramidAtlasTest, TakesHalfAsMuchAgain) {
  EXPECT_EQ(PyramidAtlas(4096, 2048).size(), IVec2(4096, 3072));
}

}  // namespace

}  // namespace foveola
