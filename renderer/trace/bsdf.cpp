#include "renderer/trace/bsdf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/trace/fresnel.h"

namespace foveola {
namespace {

constexpr float inverse_pi = std::numbers::inv_pi_v<float>;

Vec3 sample_cosine_hemisphere(const Vec2& u) {
  const float r = std::sqrt(u.y);
  const float azimuth = 2.0F * std::numbers::pi_v<float> * u.x;
  return {r * std::cos(azimuth), r * std::sin(azimuth), std::sqrt(1.0F - u.y)};
}

Vec3 sample_uniform_hemisphere(const Vec2& u) {
  const float z = 1.0F - u.y;
  const float r = std::sqrt(u.y * (1.0F + z));
  const float azimuth = 2.0F * std::numbers::pi_v<float> * u.x;
  return {r * std::cos(azimuth), r * std::sin(azimuth), z};
}

Vec3 raised_above_grazing(const Vec3& w) {
  return w.z >= smallest_cosine ? w : glm::normalize(Vec3(w.x, w.y, smallest_cosine));
}

/// What is left of u in [begin, begin + length), spread over [0, 1).
float rescaled(float u, float begin, float length) {
  constexpr float largest = 0x1.fffffep-1F;
  return std::clamp((u - begin) / length, 0.0F, largest);
}

bool has_covers(const Reflectance& reflectance) {
  const bool is_inside = reflectance.is_solid && reflectance.from_inside;
  return !is_inside &&
         (reflectance.clearcoat > 0.0F || max_component(reflectance.sheen_color) > 0.0F);
}

/// Whether nothing but the Lambertian layer reflects.
bool is_matte(const Reflectance& reflectance) {
  return reflectance.metallic == 0.0F && reflectance.specular == 0.0F &&
         reflectance.transmission == 0.0F && !has_covers(reflectance);
}

}  // namespace

Bsdf::Bsdf(const Reflectance& reflectance, const Vec3& outgoing, const ScatteringTables& tables)
    : outgoing_(raised_above_grazing(outgoing)) {
  if (is_matte(reflectance)) {
    diffuse_ = inverse_pi * reflectance.base_color;
    diffuse_probability_ = reflectance.base_color == Rgb(0.0F) ? 0.0F : 1.0F;
  } else {
    set_layers(reflectance, tables);
  }
}

void Bsdf::set_layers(const Reflectance& reflectance, const ScatteringTables& tables) {
  microfacets_ = MicrofacetLobe(reflectance.roughness, outgoing_);
  albedo_ = tables.ggx().row(reflectance.roughness);
  const SchlickAlbedo lobe = albedo_.at(outgoing_.z);
  const float dielectric = 1.0F - reflectance.metallic;
  const float opaque = dielectric * (1.0F - reflectance.transmission);

  const float base_luminance = luminance(reflectance.base_color);
  float coat_albedo = 0.0F;
  float specular_albedo = 0.0F;
  if (dielectric > 0.0F) {
    const auto [f0, coat_f90] = coat_reflectance(reflectance);
    const float coat_f0 = max_component(f0);
    coat_albedo = std::min(lobe.with(coat_f0, coat_f90), 1.0F);
    float layer = inverse_pi * (1.0F - coat_albedo);
    const float below_coat = 1.0F - albedo_.mean().with(coat_f0, coat_f90);
    if (below_coat > darkest_below_coat) {
      layer /= below_coat;
      layer_f0_ = coat_f0;
      layer_f90_ = coat_f90;
      has_coat_ = coat_f0 > 0.0F || coat_f90 > 0.0F;
    }
    diffuse_ = (opaque * layer) * reflectance.base_color;
    const float share = reflectance.is_solid ? opaque : dielectric;
    specular_albedo = share * coat_albedo;
    specular_normal_ = share * f0;
    specular_grazing_ = Rgb(share * coat_f90);
  }
  if (reflectance.metallic > 0.0F) {
    // Turquin 2019, "Practical Multiple Scattering Compensation for Microfacet Models".
    const float lost = (1.0F - lobe.white) / lobe.white;
    const Rgb metal = reflectance.metallic * (1.0F + reflectance.base_color * lost);
    specular_normal_ += metal * reflectance.base_color;
    specular_grazing_ += metal;
    specular_albedo += reflectance.metallic * glm::mix(base_luminance, 1.0F, lobe.grazing);
  }
  if (dielectric * reflectance.transmission > 0.0F) {
    add_transmission(reflectance, coat_albedo, lobe.white, tables);
  }
  const float base_albedo =
      choose_probabilities(specular_albedo, opaque * (1.0F - coat_albedo) * base_luminance);
  if (has_covers(reflectance)) {
    covers_.emplace(reflectance, outgoing_, base_albedo, tables);
    base_scale_ = covers_->base_scale();
    base_probability_ = covers_->base_probability();
  }
}

void Bsdf::add_transmission(const Reflectance& reflectance, float coat_albedo, float lobe_albedo,
                            const ScatteringTables& tables) {
  const float share = (1.0F - reflectance.metallic) * reflectance.transmission;
  transmitted_ = share * reflectance.base_color;
  if (!reflectance.is_solid) {
    transmitted_ *= 1.0F - coat_albedo;
    wall_.emplace(microfacets_.ggx(), outgoing_, lobe_albedo);
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

/// By the light that each lobe sends back; returns that of all.
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
    // Not a number: so is every sample's weight, and the path is reported.
    diffuse_ = Rgb(total);
    diffuse_probability_ = 1.0F;
  }
  return total;
}

BsdfValue Bsdf::eval(const Vec3& incoming) const {
  if (incoming.z > 0.0F) {
    const BsdfValue base = eval_reflection(incoming);
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
    const MicrofacetLobe::Facets facets = microfacets_.facets(incoming);
    const Rgb fresnel =
        glm::mix(specular_normal_, specular_grazing_, schlick_weight(facets.cosine));
    value.times_cosine = fresnel * facets.times_cosine;
    value.pdf = specular_probability_ * facets.pdf;
    if (glass_ && !is_glass_smooth_) {
      const float reflectance = glass_->reflectance(facets.cosine);
      value.times_cosine += glass_share_ * glass_->scale() * reflectance * facets.times_cosine;
      value.pdf += transmission_probability_ * reflectance * facets.pdf;
    }
  }
  if (diffuse_probability_ > 0.0F) {
    const float coat_albedo = has_coat_ ? albedo_.at(incoming.z).with(layer_f0_, layer_f90_) : 0.0F;
    value.times_cosine += diffuse_ * (std::max(0.0F, 1.0F - coat_albedo) * incoming.z);
    value.pdf += diffuse_probability_ * incoming.z * inverse_pi;
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
    if (covers_->clearcoat().is_smooth()) {
      return BsdfSample{.incoming = microfacets_.mirrored(),
                        .weight = Rgb(covers_->clearcoat_reflectance(outgoing_.z) / clearcoat),
                        .pdf = clearcoat,
                        .is_specular = true};
    }
    return reflection(covers_->clearcoat().sample(u));
  }
  const float above_base = clearcoat + covers_->sheen_probability();
  if (u_lobe < above_base) {
    return weighed(sample_uniform_hemisphere(u));
  }
  return sample_base(rescaled(u_lobe, above_base, base_probability_), u);
}

std::optional<BsdfSample> Bsdf::sample_base(float u_lobe, const Vec2& u) const {
  if (u_lobe < specular_probability_) {
    if (microfacets_.is_smooth()) {
      const Rgb reflectance =
          glm::mix(specular_normal_, specular_grazing_, schlick_weight(outgoing_.z));
      return specular(microfacets_.mirrored(), reflectance, specular_probability_);
    }
    return reflection(microfacets_.sample(u));
  }
  const float opaque_probability = specular_probability_ + diffuse_probability_;
  if (u_lobe < opaque_probability || transmission_probability_ == 0.0F) {
    return weighed(sample_cosine_hemisphere(u));
  }
  if (glass_) {
    return sample_glass(rescaled(u_lobe, opaque_probability, transmission_probability_), u);
  }
  if (microfacets_.is_smooth()) {
    return specular(-outgoing_, transmitted_, transmission_probability_);
  }
  const Vec3 incoming = wall_->sample(u);
  return incoming.z < 0.0F ? weighed(incoming) : std::nullopt;
}

std::optional<BsdfSample> Bsdf::sample_glass(float u_fresnel, const Vec2& u) const {
  const Vec3 normal = is_glass_smooth_ ? Vec3(0.0F, 0.0F, 1.0F)
                                       : microfacets_.ggx().sample_visible_normal(outgoing_, u);
  const float reflectance = glass_->reflectance(std::min(glm::dot(outgoing_, normal), 1.0F));
  if (u_fresnel < reflectance) {
    if (!is_glass_smooth_) {
      return reflection(reflected(outgoing_, normal));
    }
    return specular(microfacets_.mirrored(), Rgb(glass_share_ * reflectance),
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
    sample = weighed(incoming);
  }
  if (sample) {
    sample->radiance_scale = glass_->radiance_scale();
  }
  return sample;
}

std::optional<BsdfSample> Bsdf::reflection(const Vec3& incoming) const {
  return incoming.z > 0.0F ? weighed(incoming) : std::nullopt;
}

std::optional<BsdfSample> Bsdf::weighed(const Vec3& incoming) const {
  const BsdfValue value = eval(incoming);
  if (value.pdf == 0.0F) {
    return std::nullopt;
  }
  return BsdfSample{
      .incoming = incoming, .weight = value.times_cosine / value.pdf, .pdf = value.pdf};
}

/// share: of the light that comes from there, without the covers. probability: given the base.
BsdfSample Bsdf::specular(const Vec3& incoming, const Rgb& share, float probability) const {
  const float total = base_probability_ * probability;
  return {.incoming = incoming,
          .weight = share * (base_scale_ / total),
          .pdf = total,
          .is_specular = true};
}

}  // namespace foveola
