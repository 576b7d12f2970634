#include "renderer/trace/triangle_lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/trace/mesh_attributes.h"
#include "renderer/trace/opacity.h"
#include "renderer/trace/surface.h"
#include "renderer/trace/triangle.h"

namespace foveola {
namespace {

/// The mean over the texels, or over a grid of 1024 of them a side, so that small bright spots are
/// not missed.
Rgb mean_colour(const Texture& texture) {
  const int width = std::min(texture.width(), 1024);
  const int height = std::min(texture.height(), 1024);
  DVec3 sum(0.0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      sum += DVec3(texture.sample({(static_cast<float>(x) + 0.5F) / static_cast<float>(width),
                                   (static_cast<float>(y) + 0.5F) / static_cast<float>(height)}));
    }
  }
  return Rgb(sum / static_cast<double>(width * height));
}

/// The luminous exitance of a material's surface, both sides together.
double exitance(const Scene& scene, const Material& material) {
  Rgb radiance = material.emission;
  if (material.emissive_texture.exists()) {
    radiance *=
        mean_colour(scene.textures[static_cast<std::size_t>(material.emissive_texture.texture)]);
  }
  const int sides = material.double_sided ? 2 : 1;
  return sides * std::numbers::pi * luminance(radiance);
}

/// Uniform barycentric coordinates (Heitz 2019, "A Low-Distortion Map Between Triangle and
/// Square").
Vec2 sample_barycentric(const Vec2& u) {
  return u.x < u.y ? Vec2(0.5F * u.x, u.y - 0.5F * u.x) : Vec2(u.x - 0.5F * u.y, 0.5F * u.y);
}

}  // namespace

TriangleLights::TriangleLights(const Scene& scene)
    : scene_(scene), area_pdf_of_mesh_(scene.meshes.size(), 0.0F) {
  std::vector<double> powers;
  std::vector<double> exitance_of_mesh(scene.meshes.size(), 0.0);
  for (std::uint32_t m = 0; m < scene.meshes.size(); ++m) {
    const Mesh& mesh = scene.meshes[m];
    const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
    if (!material.is_emissive() || is_invisible(scene, mesh)) {
      continue;
    }
    exitance_of_mesh[m] = exitance(scene, material);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle triangle(mesh, t);
      const double power = triangle.area() * exitance_of_mesh[m];
      if (power > 0.0 && std::isfinite(power)) {
        emitters_.push_back({.triangle = triangle,
                             .front_normal = triangle.front_normal(),
                             .rounding_error = triangle.rounding_error(),
                             .mesh = m,
                             .index = t});
        powers.push_back(power);
        power_ += power;
      }
    }
  }
  if (powers.empty()) {
    return;
  }
  choice_.emplace(powers);
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    area_pdf_of_mesh_[m] = static_cast<float>(exitance_of_mesh[m] / power_);
  }
}

std::optional<TriangleLights::Sample> TriangleLights::sample(const Vec3& receiver,
                                                             const Vec2& u_choice,
                                                             const Vec2& u) const {
  const Emitter& emitter = emitters_[choice_->sample(u_choice)];
  const Mesh& mesh = scene_.meshes[emitter.mesh];
  const Material& material = scene_.materials[static_cast<std::size_t>(mesh.material)];
  const Vec2 barycentric = sample_barycentric(u);
  const float opaque = opacity(scene_, mesh, emitter.index, barycentric);
  if (!(opaque > 0.0F)) {
    return std::nullopt;
  }
  const Vec3 point = emitter.triangle.at(barycentric);

  const Vec3 to_receiver = receiver - point;
  const float squared_distance = glm::dot(to_receiver, to_receiver);
  const float height = glm::dot(emitter.front_normal, to_receiver);
  if (height == 0.0F || (height < 0.0F && !material.double_sided)) {
    return std::nullopt;
  }
  const Vec3 towards_receiver =
      std::copysign(emitter.rounding_error, height) * emitter.front_normal;
  const float cosine = std::abs(height) / std::sqrt(squared_distance);
  return Sample{.point = point + towards_receiver,
                .pdf = area_pdf_of_mesh_[emitter.mesh] * squared_distance / cosine,
                .radiance = opaque * emitted_radiance(scene_, mesh, emitter.index, barycentric)};
}

}  // namespace foveola
