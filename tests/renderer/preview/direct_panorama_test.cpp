#include "renderer/preview/direct_panorama.h"

#include <gtest/gtest.h>

#include "renderer/film/film_file.h"
#include "renderer/view/equirect.h"
#include "tests/renderer/preview/box_room.h"

namespace foveola {
namespace {

TEST(DirectPanorama, EveryPixelShowsWhatIsInItsMiddle) {
  const Workers workers(2);
  const Scene room = box_room(0.0F);
  const RayScene rays(room, workers);
  EquirectFilm film(100, 50);  // neither side a multiple of a tile's
  const Vec3 viewpoint(0.2F, -0.1F, 0.3F);
  show_direct_shading(room, rays, viewpoint, film, workers);
  const float pixel_rad = 2.0F * 3.14159265F / 100.0F;
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 100; ++x) {
      const Vec3 direction = direction_from_equirect(
          {(static_cast<float>(x) + 0.5F) / 100.0F, (static_cast<float>(y) + 0.5F) / 50.0F});
      ASSERT_EQ(film.sample_count(x, y), 1U);
      EXPECT_EQ(film.mean(x, y), direct_color(room, rays, viewpoint, direction, pixel_rad));
    }
  }
  // Towards -Z, head on: half of the light, and the fifth wall's 0.4 of its own, in a pixel
  // beside the middle.
  const Vec3 middle = direction_from_equirect({0.505F, 0.51F});
  const float cosine = -middle.z;
  EXPECT_NEAR(film.mean(50, 25).g, 0.5F * (0.3F + 0.7F * cosine) + 0.4F, 1e-5);
}

TEST(DirectPanorama, IsTheSameOnAnyNumberOfThreadsAndReplacesWhatWasThere) {
  const Scene room = box_room(0.1F);
  const auto hash = [&](int threads, int times) {
    const Workers workers(threads);
    const RayScene rays(room, workers);
    EquirectFilm film(256, 128);
    for (int i = 0; i < times; ++i) {
      show_direct_shading(room, rays, Vec3(0.0F), film, workers);
    }
    return film_sha256(film);
  };
  const std::string expected = hash(1, 1);
  EXPECT_EQ(hash(3, 1), expected);
  EXPECT_EQ(hash(2, 2), expected);
}

}  // namespace
}  // namespace foveola
