// The transport of light: paths from the camera, one vertex of all of a block's paths after the
// other.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "renderer/base/random.h"
#include "renderer/base/sample_job.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/lights.h"
#include "renderer/trace/path_tracer.h"
#include "renderer/trace/ray_scene.h"
#include "renderer/trace/receiver.h"
#include "renderer/trace/scattering_tables.h"
#include "renderer/trace/surface.h"

namespace foveola {

/// What of a material decides where a path goes, read once.
struct MaterialTraits {
  bool is_unlit;
  bool is_window;
  Rgb absorption_per_m;
};

/// A scene with all that is built for tracing it.
struct TracedScene {
  const Scene& scene;
  RayScene rays;
  Lights lights;
  ScatteringTables tables;
  std::vector<MaterialTraits> traits;  ///< one a material
  bool is_dark;                        ///< nothing shines: every radiance is zero

  TracedScene(const Scene& source, const Workers& workers);
};

/// Where to note what was traced; null for what need not be noted.
struct TraceNotes {
  std::vector<PathVertex>* vertices = nullptr;
  RayLog* rays = nullptr;
};

/// Traces one block of jobs. renderer/MATERIALS.md says what happens at each kind of surface.
class BlockTracer {
 public:
  /// All must outlive this object.
  BlockTracer(const TracedScene& traced, const TraceSettings& settings, TraceNotes notes = {})
      : traced_(traced), settings_(settings), notes_(notes) {}

  /// To be called once.
  RayCounts trace(const Vec3& viewpoint, std::span<const SampleJob> jobs, std::span<Rgb> radiance);

 private:
  /// A path between two vertices.
  struct Path {
    Ray ray;
    Rgb throughput{1.0F};
    Rgb radiance{0.0F};           ///< gathered so far
    float pdf;                    ///< per steradian, with which the last vertex gave the direction
    Receiver receiver;            ///< the last vertex; of no matter before the first
    float radiance_scale = 1.0F;  ///< what refraction has scaled the throughput by
    Rgb absorption_per_m{0.0F};   ///< of the solid that the path is in
    float width_m = 0.0F;         ///< of the ray at its origin
    float spread_rad;             ///< by which the ray widens
    SampleStream random;
  };

  /// What a path gains if its shadow ray is not blocked.
  struct PendingLight {
    std::size_t path;
    Rgb radiance;
  };

  struct VertexNumbers;
  struct GroupNumbers;
  enum class Step : std::uint8_t { ended, scattered, passed };

  void start(const Vec3& viewpoint, std::span<const SampleJob> jobs);
  /// Takes every active path to its next vertex.
  void advance_all();
  Hit closest_hit(const Ray& ray);
  /// Gathers light where a path has arrived, and sends it on. False if it ends there.
  bool advance(std::size_t index, Hit hit, VertexNumbers numbers);
  void attenuate(Path& path, const Hit& hit) const;
  void add_environment(Path& path) const;
  void add_emission(Path& path, const Hit& hit) const;
  /// Estimates the light that arrives at the vertex, and sends the path on.
  Step scatter(std::size_t index, const Hit& hit, const MaterialTraits& traits,
               const VertexNumbers& numbers);
  void queue_light(std::size_t index, const SurfacePoint& point, const Frame& frame,
                   const Bsdf& bsdf, const VertexNumbers& numbers);
  /// False if the direction has no origin: it lies on one side of the shading normal and on the
  /// other side of the surface.
  bool send(Path& path, const SurfacePoint& point, const Frame& frame, const BsdfSample& sample,
            const MaterialTraits& traits);
  bool survives_roulette(Path& path, float u) const;
  void add_unblocked_light();
  /// The tint of the windows on an unblocked shadow ray.
  Rgb window_transmittance(Ray ray);
  float width_at(const Path& path, const Hit& hit) const;
  void note(const Path& path, const Hit& hit) const;

  const TracedScene& traced_;
  const TraceSettings& settings_;
  TraceNotes notes_;
  int vertex_ = 0;  ///< the one that the active paths are on their way to; the first is 1
  std::vector<Path> paths_;
  std::vector<std::size_t> active_;
  std::vector<Ray> shadow_rays_;
  std::vector<PendingLight> pending_;  ///< one a shadow ray
  RayCounts counts_;
};

}  // namespace foveola
