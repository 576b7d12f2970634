#include "renderer/trace/rays/embree_device.h"

#include <utility>

#include "renderer/base/build_info.h"
#include "renderer/base/error.h"

namespace foveola {
namespace {

void keep_first_error(void* text, RTCError, const char* message) {
  auto& first = *static_cast<std::string*>(text);
  if (first.empty()) {
    first = message;
  }
}

/// Called by Embree from all its threads. Returns true: continue.
bool count_bytes(void* total, ssize_t bytes, bool /*is_done*/) {
  *static_cast<std::atomic<std::ptrdiff_t>*>(total) += bytes;
  return true;
}

/// Equal on every processor with these instructions, so that pictures are equal too.
std::string device_configuration() {
  const std::string instructions = build_info().ray_instructions;
  return instructions.empty() ? "" : "isa=" + instructions;
}

}  // namespace

EmbreeDevice::EmbreeDevice() : device_(rtcNewDevice(device_configuration().c_str())) {
  if (!device_) {
    throw Error("ray tracing (Embree)", "cannot start on this machine");
  }
  rtcSetDeviceErrorFunction(device_.get(), keep_first_error, &error_);
  rtcSetDeviceMemoryMonitorFunction(device_.get(), count_bytes, &memory_bytes_);
}

void EmbreeDevice::throw_if_failed() const {
  if (!error_.empty()) {
    throw Error("ray tracing (Embree)", std::exchange(error_, {}),
                "try a smaller scene or a machine with more memory");
  }
}

FromEmbree<RTCScene> EmbreeDevice::new_scene() const {
  FromEmbree<RTCScene> scene(rtcNewScene(device_.get()));
  throw_if_failed();
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_HIGH);
  return scene;
}

FromEmbree<RTCGeometry> EmbreeDevice::new_geometry(RTCGeometryType type) const {
  FromEmbree<RTCGeometry> geometry(rtcNewGeometry(device_.get(), type));
  throw_if_failed();
  return geometry;
}

}  // namespace foveola
