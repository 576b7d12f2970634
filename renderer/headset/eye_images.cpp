#include "renderer/headset/eye_images.h"

#include <algorithm>

#include <epoxy/gl.h>

#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

/// Our shaders' colours are encoded already: they are written as they are, and the runtime decodes
/// them, since the pictures are in sRGB.
std::int64_t chosen_format(const XrInstanceOwner& instance, XrSession session) {
  std::uint32_t count = 0;
  instance.require(instance.xr().EnumerateSwapchainFormats(session, 0, &count, nullptr),
                   "xrEnumerateSwapchainFormats");
  std::vector<std::int64_t> formats(count);
  instance.require(instance.xr().EnumerateSwapchainFormats(session, count, &count, formats.data()),
                   "xrEnumerateSwapchainFormats");
  for (const std::int64_t wanted : {GL_SRGB8_ALPHA8, GL_SRGB8}) {
    if (std::find(formats.begin(), formats.end(), wanted) != formats.end()) {
      return wanted;
    }
  }
  throw Error("headset", "its runtime takes no pictures of 8 bits in sRGB",
              "update the headset's runtime");
}

}  // namespace

EyeImages::EyeImages(const XrInstanceOwner& instance, XrSession session, std::size_t eye)
    : instance_(&instance), size_px_(instance.eye_px()[eye]), swapchain_(make_swapchain(session)) {
  make_framebuffers();
}

XrSwapchain EyeImages::make_swapchain(XrSession session) const {
  XrSwapchainCreateInfo info{XR_TYPE_SWAPCHAIN_CREATE_INFO};
  info.usageFlags = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT;
  info.format = chosen_format(*instance_, session);
  info.sampleCount = info.faceCount = info.arraySize = info.mipCount = 1;
  info.width = static_cast<std::uint32_t>(size_px_.x);
  info.height = static_cast<std::uint32_t>(size_px_.y);
  XrSwapchain made = XR_NULL_HANDLE;
  instance_->require(instance_->xr().CreateSwapchain(session, &info, &made), "xrCreateSwapchain");
  return made;
}

void EyeImages::make_framebuffers() {
  const XrFunctions& xr = instance_->xr();
  std::uint32_t count = 0;
  instance_->require(xr.EnumerateSwapchainImages(swapchain_, 0, &count, nullptr),
                     "xrEnumerateSwapchainImages");
  std::vector<XrSwapchainImageOpenGLKHR> images(count, {XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR});
  instance_->require(
      xr.EnumerateSwapchainImages(swapchain_, count, &count,
                                  reinterpret_cast<XrSwapchainImageBaseHeader*>(images.data())),
      "xrEnumerateSwapchainImages");
  depths_ = make_gl<GlRenderbuffer>(glGenRenderbuffers);
  glBindRenderbuffer(GL_RENDERBUFFER, depths_.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size_px_.x, size_px_.y);
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  for (const XrSwapchainImageOpenGLKHR& image : images) {
    framebuffers_.push_back(make_gl<GlFramebuffer>(glGenFramebuffers));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_.back().name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, image.image, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depths_.name());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw Error("headset", "OpenGL cannot draw into the runtime's pictures",
                  "update the graphics driver and the headset's runtime");
    }
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void EyeImages::begin() {
  std::uint32_t index = 0;
  instance_->require(instance_->xr().AcquireSwapchainImage(swapchain_, nullptr, &index),
                     "xrAcquireSwapchainImage");
  XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO};
  wait.timeout = XR_INFINITE_DURATION;
  instance_->require(instance_->xr().WaitSwapchainImage(swapchain_, &wait), "xrWaitSwapchainImage");
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[index].name());
  glViewport(0, 0, size_px_.x, size_px_.y);
  glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void EyeImages::end() {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  instance_->require(instance_->xr().ReleaseSwapchainImage(swapchain_, nullptr),
                     "xrReleaseSwapchainImage");
}

XrSwapchainSubImage EyeImages::sub_image() const {
  return {swapchain_, {{0, 0}, {size_px_.x, size_px_.y}}, 0};
}

}  // namespace foveola
