// Closed forms of radiometric quantities, in double.
#pragma once

#include <span>

#include "renderer/base/vec.h"

namespace foveola {

/// Irradiance at `point` of a surface with the unit normal `normal`, from a polygon of radiance 1
/// that lies wholly above the point's horizon (Lambert 1760; Arvo 1995, "Applications of Irradiance
/// Tensors", eq. 2.3). Its sign is that of the polygon's winding; corners in order.
double polygon_irradiance(std::span<const DVec3> corners, const DVec3& point, const DVec3& normal);

/// The form factor from a point to a rectangle of width x height, parallel to the point's surface
/// at `distance`, one corner straight above the point (Howell, "A Catalog of Radiation Heat
/// Transfer Configuration Factors", B-3).
double corner_rectangle_form_factor(double width, double height, double distance);

/// Reflectance of a smooth dielectric for unpolarised light. cosine: of the angle of incidence, in
/// [0, 1]; eta: the index of refraction behind the surface over that before it.
double fresnel_reflectance(double cosine, double eta);

/// A plane-parallel slab of glass in air.
struct GlassSlab {
  double ior = 1.5;
  double thickness_m = 1.0;
  double attenuation_per_m = 0.0;  ///< coefficient of Beer and Lambert's law
};

/// Transmitted and reflected shares of a slab, with all reflections between the two faces: the
/// geometric series of Stokes (1862). cosine: of the angle of incidence in air.
struct SlabShares {
  double transmitted = 0.0;
  double reflected = 0.0;
};
SlabShares slab_shares(const GlassSlab& slab, double cosine);

}  // namespace foveola
