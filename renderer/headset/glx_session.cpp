#include "renderer/headset/glx_session.h"

#include <epoxy/glx.h>

#define XR_USE_GRAPHICS_API_OPENGL
#define XR_USE_PLATFORM_XLIB
#include <openxr/openxr_platform.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

/// The context's configuration, which GLFW does not provide.
GLXFBConfig config_of(Display* display, GLXContext context) {
  int number = 0;
  glXQueryContext(display, context, GLX_FBCONFIG_ID, &number);
  const int wanted[] = {GLX_FBCONFIG_ID, number, 0};
  int count = 0;
  GLXFBConfig* const found = glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
  if (count == 0) {
    throw Error("headset", "the window's OpenGL has no configuration of GLX",
                "use a desktop with X or Xwayland");
  }
  GLXFBConfig config = found[0];
  XFree(found);
  return config;
}

XrGraphicsBindingOpenGLXlibKHR current_binding() {
  Display* const display = glXGetCurrentDisplay();
  GLXContext context = glXGetCurrentContext();
  if (display == nullptr || context == nullptr) {
    throw Error("headset", "the window's OpenGL is not GLX's", "use a desktop with X or Xwayland");
  }
  GLXFBConfig config = config_of(display, context);
  int visual = 0;
  glXGetFBConfigAttrib(display, config, GLX_VISUAL_ID, &visual);
  return {.type = XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR,
          .next = nullptr,
          .xDisplay = display,
          .visualid = static_cast<std::uint32_t>(visual),
          .glxFBConfig = config,
          .glxDrawable = glXGetCurrentDrawable(),
          .glxContext = context};
}

}  // namespace

IVec2 current_drawable_px() {
  unsigned int width = 0;
  unsigned int height = 0;
  glXQueryDrawable(glXGetCurrentDisplay(), glXGetCurrentDrawable(), GLX_WIDTH, &width);
  glXQueryDrawable(glXGetCurrentDisplay(), glXGetCurrentDrawable(), GLX_HEIGHT, &height);
  return {static_cast<int>(width), static_cast<int>(height)};
}

XrSession make_glx_session(const XrInstanceOwner& instance) {
  // Runtimes refuse a session before this call.
  XrGraphicsRequirementsOpenGLKHR requirements{XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR};
  instance.require(instance.function<PFN_xrGetOpenGLGraphicsRequirementsKHR>(
                       "xrGetOpenGLGraphicsRequirementsKHR")(instance.handle(), instance.system(),
                                                             &requirements),
                   "xrGetOpenGLGraphicsRequirementsKHR");
  const XrGraphicsBindingOpenGLXlibKHR binding = current_binding();
  XrSessionCreateInfo info{XR_TYPE_SESSION_CREATE_INFO};
  info.next = &binding;
  info.systemId = instance.system();
  XrSession session = XR_NULL_HANDLE;
  instance.require(instance.xr().CreateSession(instance.handle(), &info, &session),
                   "xrCreateSession");
  return session;
}

}  // namespace foveola
