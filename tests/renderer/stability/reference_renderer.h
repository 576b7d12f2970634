// Another renderer: the plainest path tracer there is, in double, that shares no line of transport
// with the one it judges. No next-event estimation, no importance but the cosine's, no
// acceleration.
#pragma once

#include <optional>
#include <vector>

#include "renderer/base/numbers/random.h"
#include "renderer/base/vec.h"
#include "renderer/stability/estimate.h"

namespace foveola::reference {

enum class Kind {
  diffuse,  ///< Lambertian, on both sides
  metal,    ///< a mirror; Schlick's Fresnel with the colour at normal incidence
  glass,    ///< smooth and solid, colourless; exact unpolarised Fresnel
};

struct Surface {
  Kind kind = Kind::diffuse;
  DVec3 color{0.5};
  DVec3 emission{0.0};  ///< from the front
  double ior = 1.5;
};

/// Its front is outside.
struct Sphere {
  DVec3 center{0.0};
  double radius = 1.0;
  int surface = 0;
};

/// corner + s * a + t * b with s and t in [0, 1], or s + t <= 1 for a triangle. a x b is its front.
struct Panel {
  DVec3 corner{0.0};
  DVec3 a{1.0, 0.0, 0.0};
  DVec3 b{0.0, 1.0, 0.0};
  int surface = 0;
  bool is_triangle = false;
};

struct World {
  std::vector<Surface> surfaces;
  std::vector<Sphere> spheres;
  std::vector<Panel> panels;
  DVec3 environment{0.0};
};

/// One estimate of the radiance that arrives at `origin` against `direction` (unit length). Paths
/// have at most max_depth vertices on surfaces; light that is seen directly has depth 0. It is the
/// camera's radiance: on its way through glass it is scaled by the squared ratio of the indices of
/// refraction, which cancels once the path is out again.
DVec3 radiance(const World& world, DVec3 origin, DVec3 direction, int max_depth, Pcg32& random);

/// The picture that render_blocks() makes of the same world: blocks row by row, `columns` of them
/// over half as many rows, each of 32 batches of `batch_samples` samples.
std::vector<RadianceEstimate> render(const World& world, const DVec3& viewpoint, int columns,
                                     int batch_samples, int max_depth, const Workers& workers);

}  // namespace foveola::reference
