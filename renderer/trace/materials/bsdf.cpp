#include "renderer/trace/materials/bsdf.h"

#include <algorithm>
#include <cmath>

#include "renderer/base/numbers/random.h"
#include "renderer/base/turns.h"

namespace foveola {
namespace {

Vec3 sample_uniform_hemisphere(const Vec2& u) {
  const float z = 1.0F - u.y;
  const float r = std::sqrt(u.y * (1.0F + z));
  const SineCosine azimuth = azimuth_at(u.x);
  return {r * azimuth.cosine, r * azimuth.sine, z};
}

/// The position of u in [begin, begin + length), rescaled to [0, 1).
float rescaled(float u, float begin, float length) {
  return std::clamp((u - begin) / length, 0.0F, largest_below_one);
}

bool has_covers(const Reflectance& reflectance) {
  const bool is_inside = reflectance.is_solid && reflectance.from_inside;
  return !is_inside &&
         (reflectance.clearcoat > 0.0F || max_component(reflectance.sheen_color) > 0.0F);
}

/// Whether only the Lambertian layer reflects.
bool is_matte(const Reflectance& reflectance) {
  return reflectance.metallic == 0.0F && reflectance.specular == 0.0F &&
         reflectance.transmission == 0.0F && !has_covers(reflectance);
}

/// cosine: of the outgoing direction.
OpaqueLayersOf<float> layers_of(const Reflectance& reflectance, const ScatteringTables& tables,
                                float cosine) {
  const float dielectric = 1.0F - reflectance.metallic;
  const float opaque = dielectric * (1.0F - reflectance.transmission);
  const CoatReflectance coat = coat_reflectance(reflectance);
  return OpaqueLayersOf<float>({.base_color = reflectance.base_color,
                                .metallic = reflectance.metallic,
                                .coat_f0 = coat.normal,
                                .coat_f90 = coat.grazing,
                                .coated = reflectance.is_solid ? opaque : dielectric,
                                .opaque = opaque},
                               tables.ggx().row(reflectance.roughness), cosine);
}

}  // namespace

Bsdf::Bsdf(const Reflectance& reflectance, const Vec3& outgoing, const ScatteringTables& tables,
           const Vec3& coat_normal)
    : outgoing_(raised_above_grazing(outgoing)) {
  if (is_matte(reflectance)) {
    layers_ = OpaqueLayersOf<float>(reflectance.base_color);
    diffuse_probability_ = layers_.diffuse_albedo();
  } else {
    set_layers(reflectance, tables, coat_normal);
  }
}

void Bsdf::set_layers(const Reflectance& reflectance, const ScatteringTables& tables,
                      const Vec3& coat_normal) {
  microfacets_ = MicrofacetLobe(reflectance.roughness, outgoing_);
  layers_ = layers_of(reflectance, tables, outgoing_.z);
  if ((1.0F - reflectance.metallic) * reflectance.transmission > 0.0F) {
    add_transmission(reflectance, tables);
  }
  const float base_albedo =
      choose_probabilities(layers_.specular_albedo(), layers_.diffuse_albedo());
  if (has_covers(reflectance)) {
    covers_.emplace(reflectance, outgoing_, coat_normal, base_albedo, tables);
    base_scale_ = covers_->base_scale();
    base_probability_ = covers_->base_probability();
  }
}

void Bsdf::add_transmission(const Reflectance& reflectance, const ScatteringTables& tables) {
  const float share = (1.0F - reflectance.metallic) * reflectance.transmission;
  transmitted_ = share * reflectance.base_color;
  if (!reflectance.is_solid) {
    transmitted_ *= 1.0F - layers_.coat_albedo();
    wall_.emplace(microfacets_.ggx(), outgoing_, layers_.white_albedo());
    return;
  }
  glass_share_ = share;
  is_glass_smooth_ = !is_rough_glass(reflectance.ior, reflectance.roughness);
  const float albedo = is_glass_smooth_
                           ? 1.0F
                           : tables.glass(reflectance.ior)
                                 .at(reflectance.roughness, outgoing_.z, reflectance.from_inside);
  const float eta = reflectance.from_inside ? 1.0F / reflectance.ior : reflectance.ior;
  glass_.emplace(microfacets_.ggx(), outgoing_, eta, albedo);
}

/// Chooses lobes in proportion to their albedos; returns the sum.
float Bsdf::choose_probabilities(float specular_albedo, float diffuse_albedo) {
  float transmission_albedo = 0.0F;
  if (glass_) {
    const float reflectance = glass_->reflectance(outgoing_.z);
    transmission_albedo = glm::mix(luminance(transmitted_), glass_share_, reflectance);
  } else if (wall_) {
    transmission_albedo = luminance(transmitted_);
  }
  const float total = specular_albedo + diffuse_albedo + transmission_albedo;
  // Quotients, not products with 1 / total: a single lobe has a probability of exactly 1.
  if (total > 0.0F) {
    specular_probability_ = specular_albedo / total;
    diffuse_probability_ = diffuse_albedo / total;
    transmission_probability_ = transmission_albedo / total;
  } else if (total != 0.0F) {
    // NaN, so that every sample's weight is NaN too, and the path is reported.
    layers_ = OpaqueLayersOf<float>(Rgb(total));
    diffuse_probability_ = 1.0F;
  }
  return total;
}

BsdfValue Bsdf::eval(const Vec3& incoming, bool is_reflected) const {
  if (is_reflected) {
    const BsdfValue base = incoming.z > 0.0F ? eval_reflection(incoming) : BsdfValue{};
    return covers_ ? covers_->over(base, incoming) : base;
  }
  if (incoming.z < 0.0F && (wall_ || glass_)) {
    const BsdfValue base = eval_transmission(incoming);
    return {.times_cosine = base_scale_ * base.times_cosine, .pdf = base_probability_ * base.pdf};
  }
  return {};
}

BsdfValue Bsdf::eval_reflection(const Vec3& incoming) const {
  BsdfValue value;
  if (specular_probability_ + glass_share_ > 0.0F && !microfacets_.is_smooth()) {
    const MicrofacetLobe::LobeValue facets = microfacets_.eval(incoming);
    value = layers_.specular(facets);
    value.pdf *= specular_probability_;
    if (glass_ && !is_glass_smooth_) {
      const float reflectance = glass_->reflectance(facets.cosine);
      value.times_cosine += glass_share_ * glass_->scale() * reflectance * facets.times_cosine;
      value.pdf += transmission_probability_ * reflectance * facets.pdf;
    }
  }
  if (diffuse_probability_ > 0.0F) {
    value += layers_.diffuse(incoming.z, diffuse_probability_);
  }
  return value;
}

BsdfValue Bsdf::eval_transmission(const Vec3& incoming) const {
  if (wall_ ? microfacets_.is_smooth() : is_glass_smooth_) {
    return {};
  }
  const TransmissionValue value = wall_ ? wall_->eval(incoming) : glass_->eval(incoming);
  return {.times_cosine = transmitted_ * value.times_cosine,
          .pdf = transmission_probability_ * value.pdf};
}

Rgb Bsdf::straight_transmission() const {
  return wall_ && microfacets_.is_smooth() ? base_scale_ * transmitted_ : Rgb(0.0F);
}

std::optional<BsdfSample> Bsdf::sample(float u_lobe, const Vec2& u) const {
  if (!covers_) {
    return sample_base(u_lobe, u);
  }
  const float clearcoat = covers_->clearcoat_probability();
  if (u_lobe < clearcoat) {
    return sample_clearcoat(u);
  }
  const float above_base = clearcoat + covers_->sheen_probability();
  if (u_lobe < above_base) {
    return weighed(sample_uniform_hemisphere(u), /*is_reflected=*/true);
  }
  return sample_base(rescaled(u_lobe, above_base, base_probability_), u);
}

std::optional<BsdfSample> Bsdf::sample_clearcoat(const Vec2& u) const {
  if (const std::optional<CoverLayers::Mirror> mirror = covers_->clearcoat_mirror()) {
    const float probability = covers_->clearcoat_probability();
    return BsdfSample{.incoming = mirror->incoming,
                      .weight = Rgb(mirror->reflectance / probability),
                      .pdf = probability,
                      .is_specular = true};
  }
  const std::optional<Vec3> incoming = covers_->sample_clearcoat(u);
  return incoming ? weighed(*incoming, /*is_reflected=*/true) : std::nullopt;
}

std::optional<BsdfSample> Bsdf::sample_base(float u_lobe, const Vec2& u) const {
  if (u_lobe < specular_probability_) {
    if (microfacets_.is_smooth()) {
      return specular(mirrored(), layers_.reflectance(outgoing_.z), specular_probability_);
    }
    return reflection(microfacets_.sample(azimuth_at(u.x), u.y));
  }
  const float opaque_probability = specular_probability_ + diffuse_probability_;
  if (u_lobe < opaque_probability || transmission_probability_ == 0.0F) {
    return weighed(sample_cosine_hemisphere(azimuth_at(u.x), u.y), /*is_reflected=*/true);
  }
  if (glass_) {
    return sample_glass(rescaled(u_lobe, opaque_probability, transmission_probability_), u);
  }
  if (microfacets_.is_smooth()) {
    BsdfSample straight = specular(-outgoing_, transmitted_, transmission_probability_);
    straight.is_transmitted = true;
    return straight;
  }
  const Vec3 incoming = wall_->sample(u);
  return incoming.z < 0.0F ? weighed(incoming, /*is_reflected=*/false) : std::nullopt;
}

std::optional<BsdfSample> Bsdf::sample_glass(float u_fresnel, const Vec2& u) const {
  const Vec3 normal = is_glass_smooth_ ? Vec3(0.0F, 0.0F, 1.0F)
                                       : microfacets_.ggx().sample_visible_normal(outgoing_, u);
  const float reflectance = glass_->reflectance(std::min(glm::dot(outgoing_, normal), 1.0F));
  if (u_fresnel < reflectance) {
    if (!is_glass_smooth_) {
      return reflection(reflected(outgoing_, normal));
    }
    return specular(mirrored(), Rgb(glass_share_ * reflectance),
                    transmission_probability_ * reflectance);
  }
  const Vec3 incoming = glass_->refracted(normal);
  if (!(incoming.z < 0.0F)) {
    return std::nullopt;
  }
  std::optional<BsdfSample> sample;
  if (is_glass_smooth_) {
    sample = specular(incoming, transmitted_ * ((1.0F - reflectance) * glass_->radiance_scale()),
                      transmission_probability_ * (1.0F - reflectance));
  } else {
    sample = weighed(incoming, /*is_reflected=*/false);
  }
  if (sample) {
    sample->is_transmitted = true;
    sample->radiance_scale = glass_->radiance_scale();
  }
  return sample;
}

std::optional<BsdfSample> Bsdf::reflection(const Vec3& incoming) const {
  return incoming.z > 0.0F ? weighed(incoming, /*is_reflected=*/true) : std::nullopt;
}

std::optional<BsdfSample> Bsdf::weighed(const Vec3& incoming, bool is_reflected) const {
  const BsdfValue value = eval(incoming, is_reflected);
  if (value.pdf == 0.0F) {
    return std::nullopt;
  }
  return BsdfSample{.incoming = incoming,
                    .weight = value.times_cosine / value.pdf,
                    .pdf = value.pdf,
                    .is_transmitted = !is_reflected};
}

/// share: of the light from `incoming` that is scattered, without the covers. probability: of this
/// direction if the base is sampled.
BsdfSample Bsdf::specular(const Vec3& incoming, const Rgb& share, float probability) const {
  const float total = base_probability_ * probability;
  return {.incoming = incoming,
          .weight = share * (base_scale_ / total),
          .pdf = total,
          .is_specular = true};
}

}  // namespace foveola
