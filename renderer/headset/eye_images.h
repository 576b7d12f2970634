// The pictures that a headset's runtime takes for the eyes: its swapchains, to be drawn into.
#pragma once

#include <vector>

#include "renderer/headset/xr_instance.h"
#include "renderer/window/gl_objects.h"

namespace foveola {

/// One eye's. Needs the session's context in all that it does.
class EyeImages {
 public:
  /// Of the size that the runtime recommends for this eye, 0 or 1. instance must outlive it; the
  /// session is destroyed after it. Throws Error if the runtime has no pictures of 8 bits in sRGB.
  EyeImages(const XrInstanceOwner& instance, XrSession session, std::size_t eye);

  /// Waits for the next picture and binds a framebuffer for it, in black and far away.
  void begin();
  /// Hands it to the runtime.
  void end();

  const IVec2& size_px() const { return size_px_; }
  /// The part that is seen of what was handed over last: all of it.
  XrSwapchainSubImage sub_image() const;

 private:
  XrSwapchain make_swapchain(XrSession session) const;
  void make_framebuffers();

  const XrInstanceOwner* instance_;
  IVec2 size_px_;
  XrSwapchain swapchain_ = XR_NULL_HANDLE;
  GlRenderbuffer depths_;
  std::vector<GlFramebuffer> framebuffers_;  ///< one for each picture
};

}  // namespace foveola
