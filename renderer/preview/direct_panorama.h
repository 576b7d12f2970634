// A scene all around without noise, for when people get to know it and do not judge it.
#pragma once

#include "renderer/base/work/parallel.h"
#include "renderer/film/equirect_film.h"
#include "renderer/trace/paths/direct_shading.h"

namespace foveola {

/// Clears the film and gives each of its pixels one sample, in its middle: what direct_color() says
/// of it. It can then be shown as any film, at an exposure of 0 stops. The number of threads
/// changes nothing.
void show_direct_shading(const Scene& scene, const RayScene& rays, const Vec3& viewpoint,
                         EquirectFilm& film, const Workers& workers);

}  // namespace foveola
