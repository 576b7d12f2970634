// A scene as a modelling program shows it: without noise, and lit by a lamp where the viewer is.
#pragma once

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/rays/ray_scene.h"

namespace foveola {

/// The light that surfaces get from all around; the lamp's share is the rest.
inline constexpr float direct_ambient = 0.3F;

/// What is seen where there is no surface.
inline constexpr Rgb direct_background{0.25F, 0.3F, 0.4F};

/// What the ray from `viewpoint` along `direction` shows, in [0, 1]. A surface has its base colour
/// times ambient + (1 - ambient) * the cosine between the ray and its shading normal, and what it
/// shines with; colours that are brighter than 1 are scaled to fit. Surfaces that blend show what
/// is behind them by their alpha; thin transmissive ones by their transmission, in their colour.
/// Nothing casts a shadow and nothing is random.
///
/// rays: of the scene. direction: unit length. pixel_angle_rad: of the picture's pixel, over which
/// textures are averaged.
Rgb direct_color(const Scene& scene, const RayScene& rays, const Vec3& viewpoint,
                 const Vec3& direction, float pixel_angle_rad);

}  // namespace foveola
