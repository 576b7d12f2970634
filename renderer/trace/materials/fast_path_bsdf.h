// The BSDF of opaque metallic-roughness surfaces without covers, eight at a time.
#pragma once

#include <optional>

#include "renderer/base/numbers/lanes.h"
#include "renderer/trace/materials/bsdf_value.h"
#include "renderer/trace/materials/ggx.h"
#include "renderer/trace/materials/ggx_albedo.h"
#include "renderer/trace/materials/opaque_layers.h"

namespace foveola {

/// A material's values at one point, as input of FastPathBsdfs.
struct FastPathLayers {
  Rgb base_color;
  float metallic;
  float roughness;
  CoatReflectance coat;  ///< reflectance of the dielectric coat

  /// Whether the microfacets reflect.
  bool is_shiny;
};
FastPathLayers fast_path_layers(const Reflectance& reflectance);

/// Whether FastPathBsdfs supports a surface: it is opaque and has no covers.
bool is_on_fast_path(const Reflectance& reflectance);
/// Whether FastPathBsdfs supports its roughness too: single precision is enough.
bool is_on_fast_path(const FastPathLayers& layers);

/// Collects the layers of eight surfaces; unset lanes are black.
class FastPathLayersLanes {
 public:
  void put(std::size_t lane, const FastPathLayers& layers);

 private:
  friend class FastPathBsdfs;
  Vec3Lanes base_color_{}, coat_normal_{};
  FloatLanes metallic_{}, roughness_{}, coat_grazing_{};
  bool any_shiny_ = false;
};

/// The BSDF of Bsdf for eight surfaces, with the same local directions.
class FastPathBsdfs {
 public:
  /// outgoing: unit length, z > 0. albedo must outlive this object.
  FastPathBsdfs(const FastPathLayersLanes& layers, const Vec3s& outgoing, const GgxAlbedo& albedo);

  using Values = BsdfValueOf<Floats>;
  /// Zero if incoming lies below the surface.
  Values eval(const Vec3s& incoming) const;

  struct Samples {
    Vec3s incoming;
    Vec3s weight;
    Floats pdf;  ///< 0: the sample is lost
  };
  Samples sample(const Floats& u_lobe, const Vec2s& u) const;

 private:
  OpaqueLayersOf<Floats> shiny_layers(const FastPathLayersLanes& layers,
                                      const GgxAlbedo& albedo) const;

  bool any_shiny_;
  Vec3s outgoing_;
  OpaqueLayersOf<Floats> layers_;
  std::optional<MicrofacetLobeOf<Floats>> microfacets_;  ///< only if any is shiny
  Floats specular_probability_, diffuse_probability_;
};

}  // namespace foveola
