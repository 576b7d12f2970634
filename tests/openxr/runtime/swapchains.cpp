#include <fstream>

#include <fmt/format.h>

#include "tests/openxr/runtime/state.h"

namespace foveola::test::openxr {
namespace {

const std::vector<std::int64_t> formats = {GL_SRGB8_ALPHA8, GL_RGBA8, GL_RGBA16F};

/// Textures whose content is for the application to say.
std::vector<GLuint> make_textures(const XrSwapchainCreateInfo& info) {
  std::vector<GLuint> textures(3);
  glCreateTextures(GL_TEXTURE_2D, static_cast<GLsizei>(textures.size()), textures.data());
  for (const GLuint texture : textures) {
    glTextureStorage2D(texture, 1, static_cast<GLenum>(info.format),
                       static_cast<GLsizei>(info.width), static_cast<GLsizei>(info.height));
  }
  return textures;
}

/// Its lowest row first, 4 bytes a pixel. sRGB values are not converted.
std::vector<unsigned char> pixels_of(const Swapchain& swapchain) {
  std::vector<unsigned char> pixels(std::size_t{4} * swapchain.info.width * swapchain.info.height);
  GLint buffer = 0;
  glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &buffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glGetTextureImage(swapchain.textures.at(*swapchain.released), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                    static_cast<GLsizei>(pixels.size()), pixels.data());
  glBindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(buffer));
  return pixels;
}

}  // namespace

void check_image(const XrSwapchainSubImage& image) {
  const auto& swapchain = object_of<Swapchain>(image.swapchain);
  require(swapchain.released && !swapchain.acquired, XR_ERROR_LAYER_INVALID,
          "no image was released, or one is still being drawn on");
  const auto& [offset, extent] = image.imageRect;
  const auto is_inside = [](std::int64_t from, std::int64_t length, std::int64_t size) {
    return from >= 0 && length > 0 && from + length <= size;
  };
  require(image.imageArrayIndex == 0 && is_inside(offset.x, extent.width, swapchain.info.width) &&
              is_inside(offset.y, extent.height, swapchain.info.height),
          XR_ERROR_SWAPCHAIN_RECT_INVALID, "the rectangle is empty, or not inside of the image");
}

void save_image(const XrSwapchainSubImage& image, const std::filesystem::path& file) {
  const auto& swapchain = object_of<Swapchain>(image.swapchain);
  const auto& [offset, extent] = image.imageRect;
  const std::vector<unsigned char> pixels = pixels_of(swapchain);
  std::string pixmap = fmt::format("P6\n{} {}\n255\n", extent.width, extent.height);
  // A pixmap's first row is the highest, OpenGL's is the lowest.
  for (int y = offset.y + extent.height - 1; y >= offset.y; --y) {
    for (int x = offset.x; x < offset.x + extent.width; ++x) {
      const std::size_t pixel =
          static_cast<std::size_t>(y) * swapchain.info.width + static_cast<std::size_t>(x);
      pixmap.append(reinterpret_cast<const char*>(&pixels[4 * pixel]), 3);
    }
  }
  std::ofstream(file, std::ios::binary) << pixmap;
}

XrResult EnumerateSwapchainFormats(XrSession /*session*/, std::uint32_t capacity,
                                   std::uint32_t* count, std::int64_t* given) {
  give_items(formats, capacity, count, given);
  return XR_SUCCESS;
}

XrResult CreateSwapchain(XrSession session, const XrSwapchainCreateInfo* info,
                         XrSwapchain* swapchain) {
  auto& owner = object_of<Session>(session);
  require(std::ranges::find(formats, info->format) != formats.end(),
          XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED, "the format is not offered");
  require(info->sampleCount == 1 && info->faceCount == 1 && info->arraySize == 1 &&
              info->mipCount == 1 && info->createFlags == 0,
          XR_ERROR_FEATURE_UNSUPPORTED, "images are plain");
  require(glXGetCurrentContext() == owner.gl, XR_ERROR_RUNTIME_FAILURE,
          "the session's OpenGL context is not current");
  *swapchain = handle_of<XrSwapchain>(
      owner.swapchains.emplace_back(Swapchain{.info = *info, .textures = make_textures(*info)}));
  return XR_SUCCESS;
}

XrResult EnumerateSwapchainImages(XrSwapchain swapchain, std::uint32_t capacity,
                                  std::uint32_t* count, XrSwapchainImageBaseHeader* images) {
  std::vector<XrSwapchainImageOpenGLKHR> all;
  for (const GLuint texture : object_of<Swapchain>(swapchain).textures) {
    all.push_back({XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR, nullptr, texture});
  }
  give_items(all, capacity, count, reinterpret_cast<XrSwapchainImageOpenGLKHR*>(images));
  return XR_SUCCESS;
}

XrResult AcquireSwapchainImage(XrSwapchain swapchain, const XrSwapchainImageAcquireInfo* /*info*/,
                               std::uint32_t* index) {
  auto& acquiring = object_of<Swapchain>(swapchain);
  require(!acquiring.acquired, XR_ERROR_CALL_ORDER_INVALID, "the last image was not released");
  *index = acquiring.next_image;
  acquiring.acquired = acquiring.next_image;
  acquiring.next_image =
      (acquiring.next_image + 1) % static_cast<std::uint32_t>(acquiring.textures.size());
  return XR_SUCCESS;
}

XrResult WaitSwapchainImage(XrSwapchain swapchain, const XrSwapchainImageWaitInfo* /*info*/) {
  auto& waiting = object_of<Swapchain>(swapchain);
  require(waiting.acquired && !std::exchange(waiting.is_waited_for, true),
          XR_ERROR_CALL_ORDER_INVALID, "no image is acquired, or it was waited for");
  return XR_SUCCESS;
}

XrResult ReleaseSwapchainImage(XrSwapchain swapchain, const XrSwapchainImageReleaseInfo* /*info*/) {
  auto& releasing = object_of<Swapchain>(swapchain);
  require(std::exchange(releasing.is_waited_for, false), XR_ERROR_CALL_ORDER_INVALID,
          "no image was acquired and waited for");
  releasing.released = std::exchange(releasing.acquired, std::nullopt);
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
