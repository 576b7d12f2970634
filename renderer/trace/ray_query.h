// What Embree hands through to the filters of a query.
#pragma once

#include <cstdint>

#include <embree3/rtcore.h>

namespace foveola {

struct Scene;

/// Every query goes with one of these: the filters rely on it.
struct RayQueryContext : RTCIntersectContext {
  const Scene* scene;  ///< whose surfaces the filters ask
  /// Keys by the rays' ids; null: a ray's id is its key.
  const std::uint32_t* keys = nullptr;
  std::uint32_t* met_thin_surface = nullptr;  ///< flags by the rays' ids, or null
  bool meets_any_opacity = false;             ///< rays meet all that is not fully transparent

  explicit RayQueryContext(const Scene& asked,
                           RTCIntersectContextFlags wanted = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT)
      : RTCIntersectContext{}, scene(&asked) {
    rtcInitIntersectContext(this);
    flags = wanted;
  }
};

}  // namespace foveola
