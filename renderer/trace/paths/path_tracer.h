// Radiance along rays: a unidirectional path tracer with next-event estimation.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/base/sample_job.h"
#include "renderer/base/work/parallel.h"
#include "renderer/scene/scene.h"
#include "renderer/trace/lights/light_sampling.h"
#include "renderer/trace/rays/ray_scene.h"

namespace foveola {

inline constexpr int default_vertices_before_roulette = 1;
inline constexpr int no_roulette = std::numeric_limits<int>::max();

struct TraceSettings {
  int max_depth = 8;  ///< surface vertices with next-event estimation; 1 is direct light only
  std::uint32_t seed = 0;
  /// Angle of a film pixel, over part of which textures are filtered; 0 reads their finest level.
  float pixel_angle_rad = 0.0F;
  /// Upper bound on each channel of a sample. Any finite value darkens pictures.
  float largest_radiance = std::numeric_limits<float>::infinity();
  /// Upper bound on the contribution of each light sample. Any finite value makes every vertex take
  /// the general path.
  float largest_light_sample = std::numeric_limits<float>::infinity();
  /// Number of vertices before Russian roulette begins.
  int vertices_before_roulette = default_vertices_before_roulette;
  /// Disables multiple importance sampling: light samples have weight 1, and scattered rays count
  /// only emission that no light sample finds. Every vertex then takes the general path.
  bool light_samples_alone = false;
  /// Every vertex takes the general path, for measuring the gain of the fast path.
  bool uses_general_path = false;
};

/// Rays traced, by kind.
struct RayCounts {
  std::uint64_t primary = 0;
  std::uint64_t bounce = 0;
  std::uint64_t shadow = 0;
  std::uint64_t transmittance = 0;  ///< along shadow rays, through thin surfaces and glass
  std::uint64_t total() const { return primary + bounce + shadow + transmittance; }
};

/// The traced rays of each kind, in order.
struct RayLog {
  std::vector<Ray> primary;
  std::vector<Ray> bounce;
  std::vector<Ray> shadow;
  std::vector<Ray> transmittance;
};

/// The first hit of a ray from the gaze.
struct Picked {
  std::uint32_t object = 0;  ///< see Scene's numbering
  int material = 0;          ///< index into Scene::materials
  Vec3 position{0.0F};
  float distance_m = 0.0F;
};

/// One vertex of a path, before scattering.
struct PathVertex {
  int number = 0;  ///< counted from 1; repeated by thin transmissive surfaces on the way
  std::optional<std::uint32_t> object;  ///< nullopt: the ray left the scene
  Vec3 direction{0.0F};                 ///< direction of the ray that led here
  float distance_m = 0.0F;
  Vec3 position{0.0F};
  Vec3 normal{0.0F};  ///< shading normal
  Rgb throughput{0.0F};
  Rgb radiance{0.0F};  ///< gathered up to here, without this vertex's shadow ray
  float pdf = 0.0F;    ///< per steradian, of the direction; infinite for a camera or mirror
};

struct PathRecord {
  std::vector<PathVertex> vertices;
  Rgb radiance{0.0F};
};

/// A scene ready for tracing. The Scene must outlive it. All calls are const and thread-safe.
class PathTracer {
 public:
  /// kept: see RayScene.
  PathTracer(const Scene& scene, const Workers& workers, const LightSampling& lights = {},
             KeptHierarchies* kept = nullptr);
  ~PathTracer();
  PathTracer(PathTracer&&) noexcept;
  PathTracer& operator=(PathTracer&&) noexcept;

  /// Writes the radiance that arrives at `viewpoint` along each job's direction. radiance: as many
  /// elements as jobs. Each value depends only on its job, the viewpoint and the settings.
  /// Non-finite values mark numerical failures, which the film drops. Neighbouring jobs should have
  /// neighbouring directions.
  RayCounts trace(const Vec3& viewpoint, std::span<const SampleJob> jobs, std::span<Rgb> radiance,
                  const TraceSettings& settings, const Workers& workers) const;

  /// Traces a fixed set of paths from the viewpoint in all directions, and learns light
  /// probabilities from their contributions if that helps. To be called once, before all tracing.
  void learn_lights(const Vec3& viewpoint, const Workers& workers);

  /// Traces one job and records its vertices; its radiance equals that of trace(), to the bit.
  PathRecord replay(const Vec3& viewpoint, const SampleJob& job,
                    const TraceSettings& settings) const;

  /// The rays of trace() that Embree is queried for, block after block of the jobs.
  RayLog log_rays(const Vec3& viewpoint, std::span<const SampleJob> jobs,
                  const TraceSettings& settings) const;

  /// Warnings about lights that the file may mean otherwise, one per line.
  std::vector<std::string> warnings() const;

  /// The acceleration structure of the rays.
  const RayScene& ray_scene() const;

  /// The first surface along a ray; nullopt if there is none.
  std::optional<Picked> pick(const Vec3& origin, const Vec3& direction) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace foveola
