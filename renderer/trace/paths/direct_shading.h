// A noise-free view of a scene lit by a headlamp, as in a modelling program.
#pragma once

#include "renderer/base/vec.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/rays/ray_scene.h"

namespace foveola {

/// Share of ambient light; the headlamp has the rest.
inline constexpr float direct_ambient = 0.3F;

/// Colour of rays that miss all surfaces.
inline constexpr Rgb direct_background{0.25F, 0.3F, 0.4F};

/// The display colour of the ray from `viewpoint` along `direction`, in [0, 1]. A surface has its
/// base colour times ambient + (1 - ambient) * the cosine between the ray and its shading normal,
/// plus its emission. Colours above 1 are scaled down to it. Blended surfaces are composited by
/// their alpha, thin transmissive ones by their tinted transmission. There are no shadows and no
/// random numbers.
///
/// rays: of the scene. direction: unit length. pixel_angle_rad: of the picture's pixel, over which
/// textures are averaged.
Rgb direct_color(const Scene& scene, const RayScene& rays, const Vec3& viewpoint,
                 const Vec3& direction, float pixel_angle_rad);

}  // namespace foveola
