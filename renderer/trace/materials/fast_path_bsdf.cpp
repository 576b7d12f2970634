#include "renderer/trace/materials/fast_path_bsdf.h"

#include "renderer/base/turns.h"

namespace foveola {

FastPathLayers fast_path_layers(const Reflectance& reflectance) {
  return {.base_color = reflectance.base_color,
          .metallic = reflectance.metallic,
          .roughness = reflectance.roughness,
          .coat = coat_reflectance(reflectance),
          .is_shiny = reflectance.metallic > 0.0F || reflectance.specular > 0.0F};
}

bool is_on_fast_path(const Reflectance& reflectance) {
  return reflectance.transmission == 0.0F && reflectance.clearcoat == 0.0F &&
         max_component(reflectance.sheen_color) == 0.0F;
}

bool is_on_fast_path(const FastPathLayers& layers) {
  return !layers.is_shiny || layers.roughness * layers.roughness >= min_float_alpha;
}

void FastPathLayersLanes::put(std::size_t lane, const FastPathLayers& layers) {
  base_color_.put(lane, layers.base_color);
  metallic_[lane] = layers.metallic;
  roughness_[lane] = layers.is_shiny ? layers.roughness : 1.0F;
  coat_normal_.put(lane, layers.coat.normal);
  coat_grazing_[lane] = layers.coat.grazing;
  any_shiny_ = any_shiny_ || layers.is_shiny;
}

FastPathBsdfs::FastPathBsdfs(const FastPathLayersLanes& layers, const Vec3s& outgoing,
                             const GgxAlbedo& albedo)
    : any_shiny_(layers.any_shiny_),
      outgoing_(raised_above_grazing(outgoing)),
      layers_(any_shiny_ ? shiny_layers(layers, albedo)
                         : OpaqueLayersOf<Floats>(layers.base_color_.load())) {
  if (any_shiny_) {
    const Floats roughness = layers.roughness_.load();
    microfacets_.emplace(GgxOf<Floats>{.alpha = roughness * roughness}, outgoing_);
  }
  const Floats total = layers_.specular_albedo() + layers_.diffuse_albedo();
  const LaneMask is_black = total == 0.0F;
  specular_probability_ = is_black ? Floats{} : layers_.specular_albedo() / total;
  diffuse_probability_ = is_black ? Floats{} : layers_.diffuse_albedo() / total;
}

OpaqueLayersOf<Floats> FastPathBsdfs::shiny_layers(const FastPathLayersLanes& layers,
                                                   const GgxAlbedo& albedo) const {
  const Floats metallic = layers.metallic_.load();
  const Floats dielectric = 1.0F - metallic;
  return OpaqueLayersOf<Floats>({.base_color = layers.base_color_.load(),
                                 .metallic = metallic,
                                 .coat_f0 = layers.coat_normal_.load(),
                                 .coat_f90 = layers.coat_grazing_.load(),
                                 .coated = dielectric,
                                 .opaque = dielectric},
                                albedo.row(layers.roughness_.load()), outgoing_.z);
}

FastPathBsdfs::Values FastPathBsdfs::eval(const Vec3s& incoming) const {
  const LaneMask is_above = incoming.z > 0.0F;
  Values values = layers_.diffuse(is_above ? incoming.z : Floats{}, diffuse_probability_);
  if (any_shiny_) {
    auto facets = microfacets_->eval(
        {incoming.x, incoming.y, is_above ? incoming.z : all_lanes(1.0F)}, specular_probability_);
    const LaneMask is_seen = is_above & (specular_probability_ > 0.0F);
    facets.times_cosine = is_seen ? facets.times_cosine : Floats{};
    facets.pdf = is_seen ? facets.pdf : Floats{};
    values += layers_.specular(facets);
  }
  return values;
}

FastPathBsdfs::Samples FastPathBsdfs::sample(const Floats& u_lobe, const Vec2s& u) const {
  const SinesCosines<Floats> azimuth = azimuth_at(u.x);
  Vec3s incoming = sample_cosine_hemisphere(azimuth, u.y);
  if (any_shiny_) {
    const LaneMask is_specular = u_lobe < specular_probability_;
    incoming = chosen(is_specular, microfacets_->sample(azimuth, u.y), incoming);
  }
  const Values values = eval(incoming);
  const LaneMask is_found = values.pdf != 0.0F;
  const Floats inverse = 1.0F / (is_found ? values.pdf : all_lanes(1.0F));
  return {.incoming = incoming, .weight = inverse * values.times_cosine, .pdf = values.pdf};
}

}  // namespace foveola
