// Embree's objects, owned, its device with what that says of itself, and what it hands through to
// the filters of a query.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>

#include "renderer/trace/rays/embree.h"

namespace foveola {

struct ReleaseFromEmbree {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
template <typename Handle>
using FromEmbree = std::unique_ptr<std::remove_pointer_t<Handle>, ReleaseFromEmbree>;
template <typename Handle>
using SharedFromEmbree = std::shared_ptr<std::remove_pointer_t<Handle>>;

class EmbreeDevice {
 public:
  /// Throws Error if Embree cannot start on this machine.
  EmbreeDevice();
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;

  RTCDevice handle() const { return device_.get(); }
  /// What its objects take.
  std::size_t memory_bytes() const { return static_cast<std::size_t>(memory_bytes_); }
  /// Throws Error with the first thing that went wrong since the last call, if anything did.
  void throw_if_failed() const;

  FromEmbree<RTCScene> new_scene() const;
  FromEmbree<RTCGeometry> new_geometry(RTCGeometryType type) const;

 private:
  std::atomic<std::ptrdiff_t> memory_bytes_ = 0;
  mutable std::string error_;
  FromEmbree<RTCDevice> device_;  ///< released before what it writes to
};

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
