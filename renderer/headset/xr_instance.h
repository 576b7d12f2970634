// An OpenXR runtime and its headset.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "renderer/base/clock.h"
#include "renderer/base/vec.h"
#include "renderer/headset/xr_functions.h"

namespace foveola {

/// Thrown when the session or its runtime is gone: their objects must be destroyed, and may be
/// created anew.
struct HeadsetLost {};

class XrInstanceOwner {
 public:
  /// Throws Error with a remedy if there is no loader, runtime or headset, or no support for
  /// OpenGL.
  XrInstanceOwner();
  ~XrInstanceOwner();
  XrInstanceOwner(const XrInstanceOwner&) = delete;
  XrInstanceOwner& operator=(const XrInstanceOwner&) = delete;

  XrInstance handle() const { return instance_; }
  XrSystemId system() const { return system_; }
  const XrFunctions& xr() const { return xr_; }
  /// A function of an enabled extension.
  template <typename Function>
  Function function(const char* name) const {
    return reinterpret_cast<Function>(loader_.find(instance_, name));
  }

  bool is_enabled(const char* extension) const;
  /// Whether the headset has an eye tracker that programs may use.
  bool has_eye_tracker() const { return has_eye_tracker_; }
  /// As "Monado 25.0.0".
  const std::string& runtime() const { return runtime_; }
  /// The runtime's name for the headset.
  const std::string& headset() const { return headset_; }
  /// The runtime's recommended picture size for each eye, left and right, in pixels.
  const std::array<IVec2, 2>& eye_px() const { return eye_px_; }

  /// Convert between the runtime's clock and the steady clock.
  XrTime xr_time(Nanoseconds steady) const;
  Nanoseconds steady_time(XrTime time) const;

  XrPath path(const char* text) const;

  /// Throws HeadsetLost for a lost session or instance, and Error for any other failure.
  void require(XrResult result, const char* call) const;

 private:
  void make_instance();
  void find_headset();
  void read_properties();
  void read_eyes();

  XrLoader loader_;
  std::vector<std::string> extensions_;  ///< the enabled ones
  XrInstance instance_ = XR_NULL_HANDLE;
  XrFunctions xr_;
  XrSystemId system_ = XR_NULL_SYSTEM_ID;
  bool has_eye_tracker_ = false;
  std::string runtime_;
  std::string headset_;
  std::array<IVec2, 2> eye_px_{};
  PFN_xrVoidFunction to_xr_time_ = nullptr;
  PFN_xrVoidFunction to_timespec_ = nullptr;
};

}  // namespace foveola
