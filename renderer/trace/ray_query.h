// What Embree hands through to the filters of a query.
#pragma once

#include <cstdint>

#include "renderer/trace/embree.h"

namespace foveola {

struct Scene;

/// Every query goes with one of these: the filters rely on it.
struct RayQueryContext : embree::QueryContext {
  const Scene* scene;  ///< whose surfaces the filters ask
  /// Keys by the rays' ids; null: a ray's id is its key.
  const std::uint32_t* keys = nullptr;
  std::uint32_t* met_thin_surface = nullptr;  ///< flags by the rays' ids, or null
  bool meets_any_opacity = false;             ///< rays meet all that is not fully transparent

  explicit RayQueryContext(const Scene& asked) : embree::QueryContext{}, scene(&asked) {
    embree::init(*this);
  }
};

}  // namespace foveola
