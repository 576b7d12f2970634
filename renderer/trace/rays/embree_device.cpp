#include "renderer/trace/rays/embree_device.h"

#include <utility>

#include <fmt/format.h>

#include "renderer/base/build_info.h"
#include "renderer/base/error.h"

namespace foveola {
namespace {

void keep_first_failure(void* failure, RTCError code, const char* message) {
  auto& first = *static_cast<EmbreeFailure*>(failure);
  if (first.code == RTC_ERROR_NONE) {
    first = {code, message};
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
    const RTCError code = rtcGetDeviceError(nullptr);
    throw Error("ray tracing (Embree)",
                code == RTC_ERROR_UNSUPPORTED_CPU
                    ? "cannot start: it does not support this processor"
                    : fmt::format("cannot start: error {}", static_cast<int>(code)),
                "use a processor with SSE4.2 and free memory");
  }
  rtcSetDeviceErrorFunction(device_.get(), keep_first_failure, &failure_);
  rtcSetDeviceMemoryMonitorFunction(device_.get(), count_bytes, &memory_bytes_);
}

void EmbreeDevice::throw_if_failed() const {
  if (failure_.code != RTC_ERROR_NONE) {
    const EmbreeFailure failure = std::exchange(failure_, {});
    throw Error("ray tracing (Embree)", "cannot prepare the scene: " + failure.message,
                failure.code == RTC_ERROR_OUT_OF_MEMORY
                    ? "try a smaller scene or a machine with more memory"
                    : "report this fault with the scene, as CONTRIBUTING.md describes");
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
