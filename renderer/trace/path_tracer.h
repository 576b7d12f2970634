// Radiance along rays: a unidirectional path tracer with next-event estimation.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "renderer/base/parallel.h"
#include "renderer/base/sample_job.h"
#include "renderer/scene/scene.h"

namespace foveola {

struct TraceSettings {
  int max_depth = 8;  ///< surface vertices with next-event estimation; 1 is direct light only
  std::uint32_t seed = 0;
};

/// Rays traced, by kind.
struct RayCounts {
  std::uint64_t primary = 0;
  std::uint64_t bounce = 0;
  std::uint64_t shadow = 0;
  std::uint64_t total() const { return primary + bounce + shadow; }
};

struct Picked {
  std::uint32_t object = 0;  ///< see Scene's numbering
  Vec3 position{0.0F};
  float distance = 0.0F;  ///< metres
};

/// A scene ready to be traced. It refers to the Scene it was built from, which must outlive it.
/// All calls are const and may be made from several threads.
class PathTracer {
 public:
  PathTracer(const Scene& scene, const Workers& workers);
  ~PathTracer();
  PathTracer(PathTracer&&) noexcept;
  PathTracer& operator=(PathTracer&&) noexcept;

  /// Writes the radiance that arrives at `viewpoint` along each job's direction. radiance has as
  /// many elements as jobs. Each value depends on its job, the viewpoint and the settings only; a
  /// value may be non-finite when the transport failed numerically, and the film drops it.
  /// Neighbouring jobs should have neighbouring directions.
  RayCounts trace(const Vec3& viewpoint, std::span<const SampleJob> jobs, std::span<Rgb> radiance,
                  const TraceSettings& settings, const Workers& workers) const;

  /// The first surface along a ray; empty if there is none.
  std::optional<Picked> pick(const Vec3& origin, const Vec3& direction) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace foveola
