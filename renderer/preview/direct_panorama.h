// A noise-free view of a scene in all directions, for getting to know it rather than judging it.
#pragma once

#include "renderer/base/work/parallel.h"
#include "renderer/film/equirect_film.h"
#include "renderer/trace/paths/direct_shading.h"

namespace foveola {

/// Clears the film and gives each of its pixels one sample at its centre, by direct_color(). It is
/// shown like any film, at an exposure of 0 stops. Does not depend on the number of threads.
void show_direct_shading(const Scene& scene, const RayScene& rays, const Vec3& viewpoint,
                         EquirectFilm& film, const Workers& workers);

}  // namespace foveola
