// Embree's device and objects with ownership, and the context that it passes to a query's filters.
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

/// The first failure that Embree reported.
struct EmbreeFailure {
  RTCError code = RTC_ERROR_NONE;
  std::string message;
};

class EmbreeDevice {
 public:
  /// Throws Error if Embree cannot start on this machine.
  EmbreeDevice();
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;

  RTCDevice handle() const { return device_.get(); }
  /// Memory of its objects.
  std::size_t memory_bytes() const { return static_cast<std::size_t>(memory_bytes_); }
  /// Throws Error with the first failure since the last call, if any.
  void throw_if_failed() const;

  FromEmbree<RTCScene> new_scene() const;
  FromEmbree<RTCGeometry> new_geometry(RTCGeometryType type) const;

 private:
  std::atomic<std::ptrdiff_t> memory_bytes_ = 0;
  mutable EmbreeFailure failure_;
  FromEmbree<RTCDevice> device_;  ///< released before the members that it writes to
};

struct Scene;

/// The context of every query, which the filters rely on.
struct RayQueryContext : embree::QueryContext {
  const Scene* scene;  ///< for the filters
  /// Keys by ray id; null: a ray's id is its key.
  const std::uint32_t* keys = nullptr;
  std::uint32_t* met_thin_surface = nullptr;  ///< flags by ray id, or null
  bool meets_any_opacity = false;             ///< rays hit all but fully transparent surfaces

  explicit RayQueryContext(const Scene& asked) : embree::QueryContext{}, scene(&asked) {
    embree::init(*this);
  }
};

}  // namespace foveola
