#include "renderer/trace/fast_path_bsdf.h"

#include <numbers>

#include "renderer/base/turns.h"
#include "renderer/trace/bsdf.h"

namespace foveola {
namespace {

/// The BSDF of a white Lambertian surface.
constexpr float white_diffuse = std::numbers::inv_pi_v<float>;

Vec3s raised_above_grazing(const Vec3s& w) {
  const LaneMask is_grazing = w.z < smallest_cosine;
  if (!any_lane(is_grazing)) {
    return w;
  }
  return chosen(is_grazing, normalized({w.x, w.y, all_lanes(smallest_cosine)}), w);
}

}  // namespace

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
  return !layers.is_shiny || layers.roughness * layers.roughness >= fine_alpha;
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
    : any_shiny_(layers.any_shiny_), outgoing_(raised_above_grazing(outgoing)) {
  if (any_shiny_) {
    albedo_ = albedo.rows(layers.roughness_.load());
    set_layers(layers);
    return;
  }
  const Vec3s base_color = layers.base_color_.load();
  diffuse_ = all_lanes(white_diffuse) * base_color;
  const LaneMask is_black =
      (base_color.x == 0.0F) & (base_color.y == 0.0F) & (base_color.z == 0.0F);
  diffuse_probability_ = is_black ? Floats{} : all_lanes(1.0F);
}

// The formulas are Bsdf::set_layers()'s.
void FastPathBsdfs::set_layers(const FastPathLayersLanes& layers) {
  const Floats roughness = layers.roughness_.load();
  alpha_ = roughness * roughness;
  lambda_outgoing_ = smith_lambda(alpha_, outgoing_);
  masking_outgoing_ = 1.0F / (1.0F + lambda_outgoing_);
  inverse_alpha_squared_ = 1.0F / (alpha_ * alpha_);
  density_scale_ = 4.0F * std::numbers::pi_v<float> * alpha_ * alpha_ * outgoing_.z;

  const Vec3s base_color = layers.base_color_.load();
  const Floats metallic = layers.metallic_.load();
  const Floats dielectric = 1.0F - metallic;
  const Vec3s coat_normal = layers.coat_normal_.load();
  const Floats coat_f0 = max_component(coat_normal);
  const Floats coat_f90 = layers.coat_grazing_.load();

  const SchlickAlbedos lobe = albedo_.at(outgoing_.z);
  const Floats coat_albedo = smaller(lobe.with(coat_f0, coat_f90), 1.0F);
  const Floats below_coat = 1.0F - albedo_.mean().with(coat_f0, coat_f90);
  const LaneMask is_below = below_coat > darkest_below_coat;
  layer_f0_ = is_below ? coat_f0 : Floats{};
  layer_f90_ = is_below ? coat_f90 : Floats{};
  const Floats layer =
      white_diffuse * (1.0F - coat_albedo) / (is_below ? below_coat : all_lanes(1.0F));
  diffuse_ = (dielectric * layer) * base_color;

  const Floats lost = (1.0F - lobe.white) / lobe.white;
  const Vec3s metal = metallic * (all_lanes(Vec3(1.0F)) + lost * base_color);
  const Floats coat = dielectric * coat_f90;
  specular_normal_ = dielectric * coat_normal + metal * base_color;
  specular_grazing_ = Vec3s{coat, coat, coat} + metal;

  const Floats base_luminance = luminance(base_color);
  const Floats metal_albedo = base_luminance * (1.0F - lobe.grazing) + lobe.grazing;
  const Floats specular_albedo = dielectric * coat_albedo + metallic * metal_albedo;
  const Floats diffuse_albedo = dielectric * (1.0F - coat_albedo) * base_luminance;
  const Floats total = specular_albedo + diffuse_albedo;
  const LaneMask is_black = total == 0.0F;
  specular_probability_ = is_black ? Floats{} : specular_albedo / total;
  diffuse_probability_ = is_black ? Floats{} : diffuse_albedo / total;
}

FastPathBsdfs::Values FastPathBsdfs::eval(const Vec3s& incoming) const {
  const LaneMask is_above = incoming.z > 0.0F;
  const Floats cosine = is_above ? incoming.z : Floats{};
  Values values;
  if (any_shiny_) {
    const Floats coat_albedo = albedo_.at(cosine).with(layer_f0_, layer_f90_);
    values.times_cosine = (larger(1.0F - coat_albedo, 0.0F) * cosine) * diffuse_;
  } else {
    values.times_cosine = cosine * diffuse_;
  }
  values.pdf = diffuse_probability_ * cosine * white_diffuse;
  if (any_shiny_) {
    add_facets({incoming.x, incoming.y, is_above ? incoming.z : all_lanes(1.0F)}, values);
    const Vec3s none{};
    values.times_cosine = chosen(is_above, values.times_cosine, none);
    values.pdf = is_above ? values.pdf : Floats{};
  }
  return values;
}

// The formulas are MicrofacetLobe::facets()'s.
void FastPathBsdfs::add_facets(const Vec3s& incoming, Values& values) const {
  const Vec3s half = normalized(outgoing_ + incoming);
  const Floats s = (half.x * half.x + half.y * half.y) * inverse_alpha_squared_ + half.z * half.z;
  const Floats inverse_masking = 1.0F + lambda_outgoing_ + smith_lambda(alpha_, incoming);
  const Floats times_cosine = 1.0F / (density_scale_ * s * s * inverse_masking);
  const Floats weight = schlick_weight(smaller(dot(outgoing_, half), 1.0F));
  const Vec3s fresnel = (1.0F - weight) * specular_normal_ + weight * specular_grazing_;
  const LaneMask is_shiny = specular_probability_ > 0.0F;
  const Floats facets = is_shiny ? times_cosine : Floats{};
  values.times_cosine = values.times_cosine + facets * fresnel;
  values.pdf += specular_probability_ * facets * inverse_masking * masking_outgoing_;
}

FastPathBsdfs::Samples FastPathBsdfs::sample(const Floats& u_lobe, const Vec2s& u) const {
  const SinesCosines<Floats> azimuth = sine_cosine_of_turns(u.x);
  const Floats r = square_root(u.y);
  Vec3s incoming{r * azimuth.cosine, r * azimuth.sine, square_root(1.0F - u.y)};
  if (any_shiny_) {
    const LaneMask is_specular = u_lobe < specular_probability_;
    const Vec3s normal = sample_visible_normal({azimuth.cosine, azimuth.sine}, u.y);
    const Vec3s mirrored = normalized((2.0F * dot(outgoing_, normal)) * normal - outgoing_);
    incoming = chosen(is_specular, mirrored, incoming);
  }
  const Values values = eval(incoming);
  const LaneMask is_found = values.pdf != 0.0F;
  const Floats inverse = 1.0F / (is_found ? values.pdf : all_lanes(1.0F));
  return {.incoming = incoming, .weight = inverse * values.times_cosine, .pdf = values.pdf};
}

// The formulas are Ggx::visible_normal()'s.
Vec3s FastPathBsdfs::sample_visible_normal(const Vec2s& azimuth, const Floats& u) const {
  const Vec3s stretched = normalized({alpha_ * outgoing_.x, alpha_ * outgoing_.y, outgoing_.z});
  const Floats depth = u * (1.0F + stretched.z);
  const Floats r = square_root(depth * (2.0F - depth));
  return normalized({alpha_ * (r * azimuth.x + stretched.x), alpha_ * (r * azimuth.y + stretched.y),
                     (1.0F - u) * (1.0F + stretched.z)});
}

}  // namespace foveola
