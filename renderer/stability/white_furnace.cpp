#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "renderer/base/numbers/random.h"
#include "renderer/stability/checks.h"
#include "renderer/stability/estimate.h"
#include "renderer/stability/shapes.h"

namespace foveola {
namespace {

/// Number of vertices beyond which paths contribute less than 1e-4. Half is lost at each vertex of
/// the closed furnace. But light that enters a glass ball at random may be reflected inside for
/// long: 0.4 % (smooth) and 1 % (roughness 0.2) of the light after 40 vertices, 0.1 % after 400.
constexpr int furnace_depth = 4000;

/// Allowance for floats and tables in a product of a few vertices.
constexpr double rounding = 1e-4;

constexpr std::array<float, 6> roughnesses{0.001F, 0.1F, 0.3F, 0.5F, 0.8F, 1.0F};
constexpr std::array<double, 4> cosines{1.0, 0.5, 0.1, 0.01};

/// A kind of material at one roughness.
struct Variety {
  std::string name;
  bool lossless = false;  ///< otherwise it may reflect less than it receives, but never more
  bool solid = false;     ///< valid on closed meshes only
  Material (*at)(float roughness) = nullptr;
};

Material clearcoat_over(Material base, float roughness) {
  base.clearcoat = 1.0F;
  base.clearcoat_roughness = roughness;
  return base;
}

const std::vector<Variety>& varieties() {
  static const std::vector<Variety> all = {
      {"diffuse", true, false, [](float) { return matte(Rgb(1.0F)); }},
      {"dielectric", true, false, [](float r) { return dielectric(1.0F, r); }},
      {"metal", true, false, [](float r) { return metal(1.0F, r); }},
      {"half metal", false, false,
       [](float r) {
         Material material = dielectric(1.0F, r);
         material.metallic = 0.5F;
         return material;
       }},
      {"clearcoat on diffuse", false, false,
       [](float r) { return clearcoat_over(matte(Rgb(1.0F)), r); }},
      {"clearcoat on metal", false, false,
       [](float r) { return clearcoat_over(metal(1.0F, 0.3F), r); }},
      {"sheen on diffuse", false, false,
       [](float r) {
         Material material = matte(Rgb(1.0F));
         material.sheen_color = Rgb(1.0F);
         material.sheen_roughness = r;
         return material;
       }},
      {"thin glass", true, false,
       [](float r) {
         Material material = glass(r);
         material.is_solid = false;
         return material;
       }},
      {"solid glass", true, true, [](float r) { return glass(r); }},
  };
  return all;
}

/// Compares a material's radiance with a furnace of radiance 1.
StabilityFigure judge(std::string name, const RadianceEstimate& estimate, bool lossless,
                      const StabilityEffort& effort) {
  return lossless ? deviation(std::move(name), estimate, DVec3(1.0), rounding, effort.tolerance)
                  : excess(std::move(name), estimate, 1.0, rounding, effort.tolerance);
}

/// Objects are so far apart that each fills little of another's view.
constexpr float spacing = 10.0F;

Vec3 place_of(std::size_t object) { return {spacing * static_cast<float>(object), 0.0F, 0.0F}; }

/// A ball of radius 1, of flat triangles: a smooth shading normal bends what a furnace shows near
/// the silhouette.
Mesh ball(std::size_t object) {
  Mesh mesh = placed(flat_shaded(inside_out(inward_sphere(1.0F, 4, 0))), 1.0F, Quat(1, 0, 0, 0),
                     place_of(object));
  mesh.material = static_cast<int>(object);
  return mesh;
}

/// A ball of each material under a sky of radiance 1.
Scene balls_under_sky(const std::vector<Material>& materials) {
  Scene scene;
  scene.materials = materials;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    scene.meshes.push_back(ball(i));
  }
  scene.environment = constant_environment(1.0F);
  return scene;
}

/// A level plate of each material, none of which sees another.
Scene plates_under_sky(const std::vector<Material>& materials) {
  Scene scene;
  scene.materials = materials;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    scene.meshes.push_back(
        quad(place_of(i) + Vec3(-1, 0, 1), Vec3(2, 0, 0), Vec3(0, 0, -2), static_cast<int>(i)));
  }
  scene.environment = constant_environment(1.0F);
  return scene;
}

/// Each ball in a closed sphere of its own that emits one half and reflects one half.
Scene balls_in_enclosures(const std::vector<Material>& materials) {
  Scene scene = balls_under_sky(materials);
  scene.environment.reset();
  const int wall = static_cast<int>(scene.materials.size());
  scene.materials.push_back(matte(Rgb(0.5F)));
  scene.materials.back().emission = Rgb(0.5F);
  for (std::size_t i = 0; i < materials.size(); ++i) {
    scene.meshes.push_back(
        placed(flat_shaded(inward_sphere(4.0F, 3, wall)), 1.0F, Quat(1, 0, 0, 0), place_of(i)));
  }
  return scene;
}

Measurement plate_at(std::size_t object, double cosine) {
  const Vec3 from(static_cast<float>(-std::sqrt(1.0 - cosine * cosine)), static_cast<float>(cosine),
                  0.0F);
  return single_ray(place_of(object) + 0.9F * from, -from, furnace_depth, 1.0);
}

/// Rays from a distance of 3 that nearly fill the disc of the ball, including grazing ones.
Measurement across_ball(std::size_t object) {
  return {.viewpoint = place_of(object) + Vec3(0, 0, 3),
          .direction =
              [](const Vec2& u) {
                const float sine = 0.33F * std::sqrt(u.x);
                const float turn = 2.0F * std::numbers::pi_v<float> * u.y;
                return Vec3(sine * std::cos(turn), sine * std::sin(turn),
                            -std::sqrt(1.0F - sine * sine));
              },
          .max_depth = furnace_depth,
          .expected = 1.0};
}

/// The furnaces of one variety at all roughnesses.
class Furnace {
 public:
  Furnace(const Variety& variety, const StabilityRun& run) : variety_(variety), run_(run) {
    for (const float roughness : roughnesses) {
      materials_.push_back(variety.at(roughness));
    }
  }

  StabilityFigure open() const {
    std::vector<StabilityFigure> figures = across_balls(balls_under_sky(materials_));
    if (!variety_.solid) {
      const std::vector<StabilityFigure> of_plates = on_plates();
      figures.insert(figures.end(), of_plates.begin(), of_plates.end());
    }
    return worst_of(title("open"), figures);
  }

  StabilityFigure closed() const {
    return worst_of(title("closed"), across_balls(balls_in_enclosures(materials_)));
  }

 private:
  std::string title(const char* kind) const {
    return fmt::format("white furnace, {}, {}: {}", kind, variety_.name,
                       variety_.lossless ? "off 1" : "above 1");
  }

  std::vector<StabilityFigure> across_balls(const Scene& scene) const {
    const PathTracer tracer(scene, run_.workers);
    std::vector<StabilityFigure> figures;
    for (std::size_t i = 0; i < roughnesses.size(); ++i) {
      figures.push_back(
          show(fmt::format("ball of roughness {}", roughnesses[i]), tracer, across_ball(i)));
    }
    return figures;
  }

  std::vector<StabilityFigure> on_plates() const {
    const Scene scene = plates_under_sky(materials_);
    const PathTracer tracer(scene, run_.workers);
    std::vector<StabilityFigure> figures;
    for (std::size_t i = 0; i < roughnesses.size(); ++i) {
      for (const double cosine : cosines) {
        figures.push_back(
            show(fmt::format("plate of roughness {} seen at cosine {}", roughnesses[i], cosine),
                 tracer, plate_at(i, cosine)));
      }
    }
    return figures;
  }

  StabilityFigure show(std::string name, const PathTracer& tracer,
                       const Measurement& measurement) const {
    return judge(std::move(name), measure(tracer, measurement, run_), variety_.lossless,
                 run_.effort);
  }

  const Variety& variety_;
  const StabilityRun& run_;
  std::vector<Material> materials_;
};

/// Any allowed values of a material, its colours white so that they absorb nothing.
Material random_material(Pcg32& random) {
  const auto uniform = [&] { return static_cast<float>(random.uniform()); };
  // Half of the layers are absent, as they are in most scenes.
  const auto layer = [&] { return std::max(0.0F, 2.0F * uniform() - 1.0F); };
  Material material;
  material.metallic = layer();
  material.roughness = uniform();
  material.ior = 1.0F + uniform();
  material.specular = uniform();
  material.transmission = layer();
  material.is_solid = random.below(2) == 0;
  material.clearcoat = layer();
  material.clearcoat_roughness = uniform();
  material.sheen_color = Rgb(layer());
  material.sheen_roughness = uniform();
  return material;
}

std::string describe(const Material& material) {
  return fmt::format(
      "metallic {:.2f}, roughness {:.2f}, ior {:.2f}, specular {:.2f}, transmission {:.2f}{}, "
      "clearcoat {:.2f} of roughness {:.2f}, sheen {:.2f} of roughness {:.2f}",
      material.metallic, material.roughness, material.ior, material.specular, material.transmission,
      material.is_solid ? " solid" : "", material.clearcoat, material.clearcoat_roughness,
      material.sheen_color.r, material.sheen_roughness);
}

}  // namespace

std::vector<StabilityFigure> check_mixed_layers(const StabilityRun& run) {
  constexpr std::size_t count = 50;
  Pcg32 random(3);
  std::vector<Material> materials;
  for (std::size_t i = 0; i < count; ++i) {
    materials.push_back(random_material(random));
  }
  const Scene scene = balls_under_sky(materials);
  const PathTracer tracer(scene, run.workers);
  std::vector<StabilityFigure> figures;
  for (std::size_t i = 0; i < count; ++i) {
    figures.push_back(excess(describe(materials[i]), measure(tracer, across_ball(i), run), 1.0,
                             rounding, run.effort.tolerance));
    run.progress(static_cast<double>(i + 1) / count);
  }
  return {worst_of("white furnace, open, any material: above 1", figures)};
}

std::vector<StabilityFigure> check_white_furnaces(const StabilityRun& run) {
  std::vector<StabilityFigure> figures;
  const double steps = 2.0 * static_cast<double>(varieties().size());
  const auto add = [&](StabilityFigure figure) {
    figures.push_back(std::move(figure));
    run.progress(static_cast<double>(figures.size()) / steps);
  };
  for (const Variety& variety : varieties()) {
    const Furnace furnace(variety, run);
    add(furnace.open());
    add(furnace.closed());
  }
  return figures;
}

}  // namespace foveola
