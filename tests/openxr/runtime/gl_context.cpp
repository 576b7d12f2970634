#include "tests/openxr/runtime/gl_context.h"

#include <array>

namespace foveola::test::openxr {
namespace {

int config_of(Display* display, GLXFBConfig config) {
  int id = 0;
  glXGetFBConfigAttrib(display, config, GLX_FBCONFIG_ID, &id);
  return id;
}

int config_of(Display* display, GLXContext context) {
  int id = 0;
  glXQueryContext(display, context, GLX_FBCONFIG_ID, &id);
  return id;
}

GLenum target_of(const XrSwapchainCreateInfo& info) {
  return info.arraySize > 1 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
}

/// What is bound to a texture target, bound to it again at the end of the scope.
class KeptTexture {
 public:
  explicit KeptTexture(GLenum target) : target_(target) {
    glGetIntegerv(target == GL_TEXTURE_2D ? GL_TEXTURE_BINDING_2D : GL_TEXTURE_BINDING_2D_ARRAY,
                  &name_);
  }
  ~KeptTexture() { glBindTexture(target_, static_cast<GLuint>(name_)); }
  KeptTexture(const KeptTexture&) = delete;
  KeptTexture& operator=(const KeptTexture&) = delete;

 private:
  GLenum target_;
  GLint name_ = 0;
};

/// How the application wants pixels to be laid out, again so at the end of the scope. Within it,
/// rows lie one behind the other without gaps.
class PlainPacking {
 public:
  PlainPacking() {
    for (std::size_t i = 0; i < settings.size(); ++i) {
      glGetIntegerv(settings[i], &before_[i]);
      glPixelStorei(settings[i], settings[i] == GL_PACK_ALIGNMENT ? 1 : 0);
    }
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &buffer_);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  }
  ~PlainPacking() {
    for (std::size_t i = 0; i < settings.size(); ++i) {
      glPixelStorei(settings[i], before_[i]);
    }
    glBindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(buffer_));
  }
  PlainPacking(const PlainPacking&) = delete;
  PlainPacking& operator=(const PlainPacking&) = delete;

 private:
  static constexpr std::array<GLenum, 7> settings = {
      GL_PACK_ALIGNMENT,   GL_PACK_ROW_LENGTH,   GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS,
      GL_PACK_SKIP_IMAGES, GL_PACK_IMAGE_HEIGHT, GL_PACK_SWAP_BYTES};
  std::array<GLint, 7> before_{};
  GLint buffer_ = 0;
};

/// Of each level of detail; what is in it is for the application to say.
void give_storage(const XrSwapchainCreateInfo& info) {
  const bool is_depth = info.format == GL_DEPTH_COMPONENT24;
  const GLenum components = is_depth ? GL_DEPTH_COMPONENT : GL_RGBA;
  const GLenum type = is_depth ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE;
  const auto format = static_cast<GLint>(info.format);
  const GLenum target = target_of(info);
  for (std::uint32_t level = 0; level < info.mipCount; ++level) {
    const auto width = static_cast<GLsizei>(std::max(info.width >> level, 1U));
    const auto height = static_cast<GLsizei>(std::max(info.height >> level, 1U));
    const auto at = static_cast<GLint>(level);
    if (target == GL_TEXTURE_2D) {
      glTexImage2D(target, at, format, width, height, 0, components, type, nullptr);
    } else {
      glTexImage3D(target, at, format, width, height, static_cast<GLsizei>(info.arraySize), 0,
                   components, type, nullptr);
    }
  }
  glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(info.mipCount) - 1);
}

}  // namespace

GlBinding binding_of(const void* next) {
  const auto* const binding =
      chained<XrGraphicsBindingOpenGLXlibKHR>(next, XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR);
  constexpr XrResult invalid = XR_ERROR_GRAPHICS_DEVICE_INVALID;
  require(binding != nullptr, invalid, "no XrGraphicsBindingOpenGLXlibKHR is chained");
  require(is_enabled(XR_KHR_OPENGL_ENABLE_EXTENSION_NAME), invalid,
          "the extension for OpenGL is not enabled");
  require(binding->xDisplay != nullptr, invalid, "the binding has no display");
  require(binding->glxFBConfig != nullptr, invalid, "the binding has no GLXFBConfig");
  require(binding->glxDrawable != 0, invalid, "the binding has no drawable");
  require(binding->glxContext != nullptr, invalid, "the binding has no context");
  require(binding->visualid != 0, invalid, "the binding has no visual");
  require(config_of(binding->xDisplay, binding->glxFBConfig) ==
              config_of(binding->xDisplay, binding->glxContext),
          invalid, "the binding's GLXFBConfig is not that of its context");
  return {binding->xDisplay, binding->glxDrawable, binding->glxContext};
}

CurrentContext::CurrentContext(const GlBinding& gl)
    : display_(gl.display),
      was_current_(glXGetCurrentContext() == gl.context),
      context_before_(glXGetCurrentContext()),
      drawing_before_(glXGetCurrentDrawable()),
      reading_before_(glXGetCurrentReadDrawable()) {
  if (!was_current_) {
    require(glXMakeContextCurrent(gl.display, gl.drawable, gl.drawable, gl.context) != 0,
            XR_ERROR_RUNTIME_FAILURE, "the session's OpenGL context cannot be made current");
  }
}

CurrentContext::~CurrentContext() {
  if (!was_current_) {
    glXMakeContextCurrent(display_, drawing_before_, reading_before_, context_before_);
  }
}

std::vector<GLuint> make_textures(const XrSwapchainCreateInfo& info, std::size_t count) {
  const GLenum target = target_of(info);
  const KeptTexture kept(target);
  std::vector<GLuint> textures(count);
  glGenTextures(static_cast<GLsizei>(count), textures.data());
  for (const GLuint texture : textures) {
    glBindTexture(target, texture);
    give_storage(info);
    GLint width = 0;
    glGetTexLevelParameteriv(target, 0, GL_TEXTURE_WIDTH, &width);
    require(width == static_cast<GLint>(info.width), XR_ERROR_OUT_OF_MEMORY,
            "OpenGL makes no texture of this size and format");
  }
  return textures;
}

void remove_textures(const std::vector<GLuint>& textures) {
  glDeleteTextures(static_cast<GLsizei>(textures.size()), textures.data());
}

std::vector<unsigned char> pixels_of(const Swapchain& swapchain, GLuint texture,
                                     const XrRect2Di& rectangle, std::uint32_t layer) {
  constexpr std::size_t channels = 3;
  const XrSwapchainCreateInfo& info = swapchain.info;
  const GLenum target = target_of(info);
  const std::size_t layer_bytes = channels * info.width * info.height;
  std::vector<unsigned char> whole(layer_bytes * info.arraySize);
  {
    const KeptTexture kept(target);
    const PlainPacking packing;
    glBindTexture(target, texture);
    glGetTexImage(target, 0, GL_RGB, GL_UNSIGNED_BYTE, whole.data());
  }
  std::vector<unsigned char> pixels;
  for (int y = 0; y < rectangle.extent.height; ++y) {
    const auto row = whole.begin() +
                     static_cast<std::ptrdiff_t>(
                         layer * layer_bytes +
                         channels * (static_cast<std::size_t>(rectangle.offset.y + y) * info.width +
                                     static_cast<std::size_t>(rectangle.offset.x)));
    pixels.insert(pixels.end(), row,
                  row + static_cast<std::ptrdiff_t>(channels) * rectangle.extent.width);
  }
  return pixels;
}

}  // namespace foveola::test::openxr
