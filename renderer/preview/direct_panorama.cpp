#include "renderer/preview/direct_panorama.h"

#include <algorithm>
#include <vector>

#include "renderer/view/equirect.h"

namespace foveola {
namespace {

/// Number of pixels that one task shades.
constexpr std::size_t pixels_in_task = 512;

/// The centres of the pixels of the rows [begin, end).
std::vector<ViewSample> middles(const EquirectFilm& film, int begin, int end) {
  const Vec2 size(film.width(), film.height());
  std::vector<ViewSample> samples;
  samples.reserve(static_cast<std::size_t>(film.width()) * static_cast<std::size_t>(end - begin));
  for (int y = begin; y < end; ++y) {
    for (int x = 0; x < film.width(); ++x) {
      const Vec2 image = (Vec2(x, y) + 0.5F) / size;
      samples.push_back({.direction = direction_from_equirect(image), .image = image});
    }
  }
  return samples;
}

}  // namespace

void show_direct_shading(const Scene& scene, const RayScene& rays, const Vec3& viewpoint,
                         EquirectFilm& film, const Workers& workers) {
  film.clear();
  NumberedBatch batch;
  std::vector<Rgb> colors;
  const float pixel_rad = pixel_angle_rad(film.width());
  for (int top = 0; top < film.height(); top += EquirectFilm::tile_size) {
    const int bottom = std::min(top + EquirectFilm::tile_size, film.height());
    film.number(middles(film, top, bottom), batch, workers);
    colors.resize(batch.jobs.size());
    workers.for_each_block(
        batch.jobs.size(), pixels_in_task, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            colors[i] = direct_color(scene, rays, viewpoint, batch.jobs[i].direction, pixel_rad);
          }
        });
    film.add(batch, colors, workers);
  }
}

}  // namespace foveola
