#include <algorithm>

#include "tests/openxr/runtime/calls.h"
#include "tests/openxr/runtime/gl_context.h"
#include "tests/openxr/runtime/two_calls.h"

namespace foveola::test::openxr {
namespace {

constexpr std::size_t images_of_a_swapchain = 3;

void check_format(const XrSwapchainCreateInfo& info) {
  const std::vector<std::int64_t>& formats = runtime().script.swapchain_formats;
  require(std::find(formats.begin(), formats.end(), info.format) != formats.end(),
          XR_ERROR_SWAPCHAIN_FORMAT_UNSUPPORTED, "the format is not offered");
  const bool is_depth = info.format == GL_DEPTH_COMPONENT24;
  require(is_depth || (info.usageFlags & XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT) == 0,
          XR_ERROR_VALIDATION_FAILURE, "a colour cannot be used as a depth");
}

void check_size(const XrSwapchainCreateInfo& info) {
  const SizePx& max = runtime().script.max_swapchain_px;
  require(info.width > 0 && info.width <= max.width && info.height > 0 && info.height <= max.height,
          XR_ERROR_VALIDATION_FAILURE, "the images are empty, or larger than the system's largest");
  require(info.sampleCount == 1, XR_ERROR_FEATURE_UNSUPPORTED, "there is one sample a pixel");
  require(info.faceCount == 1, XR_ERROR_FEATURE_UNSUPPORTED, "there are no cubes");
  require(info.arraySize > 0 && info.mipCount > 0, XR_ERROR_VALIDATION_FAILURE,
          "there are no layers, or no levels");
  constexpr XrSwapchainCreateFlags supported = XR_SWAPCHAIN_CREATE_STATIC_IMAGE_BIT;
  require((info.createFlags & ~supported) == 0, XR_ERROR_FEATURE_UNSUPPORTED,
          "images can be static, but not protected");
}

void log_swapchain(const Swapchain& made) {
  runtime().log.write({{"kind", "swapchain"},
                       {"swapchain", made.number},
                       {"width", made.info.width},
                       {"height", made.info.height},
                       {"format", made.info.format},
                       {"array_size", made.info.arraySize},
                       {"images", made.textures.size()}});
}

}  // namespace

XrResult enumerate_swapchain_formats(XrSession session, std::uint32_t capacity,
                                     std::uint32_t* count, std::int64_t* formats) {
  session_of(session);
  give_items(runtime().script.swapchain_formats, capacity, count, formats);
  return XR_SUCCESS;
}

XrResult create_swapchain(XrSession session, const XrSwapchainCreateInfo* create_info,
                          XrSwapchain* swapchain) {
  const Session& owner = session_of(session);
  const XrSwapchainCreateInfo& info =
      checked(create_info, XR_TYPE_SWAPCHAIN_CREATE_INFO, "the information for the swapchain");
  XrSwapchain& place = place_for(swapchain, "the place for the swapchain");
  check_format(info);
  check_size(info);
  const bool is_static = (info.createFlags & XR_SWAPCHAIN_CREATE_STATIC_IMAGE_BIT) != 0;
  auto made = std::make_shared<Swapchain>();
  made->info = info;
  {
    const CurrentContext current(owner.gl);
    made->textures = make_textures(info, is_static ? 1 : images_of_a_swapchain);
  }
  place = runtime().swapchains.add(made);
  made->number = runtime().swapchains.number_of(place);
  log_swapchain(*made);
  return XR_SUCCESS;
}

XrResult destroy_swapchain(XrSwapchain swapchain) {
  const std::shared_ptr<Swapchain> removed = runtime().swapchains.remove(swapchain);
  const CurrentContext current(current_session().gl);
  remove_textures(removed->textures);
  return XR_SUCCESS;
}

XrResult enumerate_swapchain_images(XrSwapchain swapchain, std::uint32_t capacity,
                                    std::uint32_t* count, XrSwapchainImageBaseHeader* images) {
  const std::shared_ptr<Swapchain> listed = runtime().swapchains.at(swapchain);
  std::vector<XrSwapchainImageOpenGLKHR> all;
  for (const GLuint texture : listed->textures) {
    all.push_back({XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR, nullptr, texture});
  }
  give_structures(all, XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR, capacity, count,
                  reinterpret_cast<XrSwapchainImageOpenGLKHR*>(images));
  return XR_SUCCESS;
}

XrResult acquire_swapchain_image(XrSwapchain swapchain,
                                 const XrSwapchainImageAcquireInfo* acquire_info,
                                 std::uint32_t* index) {
  const std::shared_ptr<Swapchain> acquired = runtime().swapchains.at(swapchain);
  check_if_given(acquire_info, XR_TYPE_SWAPCHAIN_IMAGE_ACQUIRE_INFO, "the way to acquire");
  std::uint32_t& place = place_for(index, "the place for the index");
  const bool is_static = (acquired->info.createFlags & XR_SWAPCHAIN_CREATE_STATIC_IMAGE_BIT) != 0;
  require(!is_static || !acquired->last_released, XR_ERROR_CALL_ORDER_INVALID,
          "a static image is acquired only once");
  require(acquired->acquired.size() < acquired->textures.size(), XR_ERROR_CALL_ORDER_INVALID,
          "all images are acquired, and none was released");
  place = acquired->next_image;
  acquired->acquired.push_back(place);
  acquired->next_image =
      (acquired->next_image + 1) % static_cast<std::uint32_t>(acquired->textures.size());
  return XR_SUCCESS;
}

XrResult wait_swapchain_image(XrSwapchain swapchain, const XrSwapchainImageWaitInfo* wait_info) {
  const std::shared_ptr<Swapchain> waited = runtime().swapchains.at(swapchain);
  checked(wait_info, XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO, "how to wait");
  require(!waited->acquired.empty(), XR_ERROR_CALL_ORDER_INVALID, "no image is acquired");
  require(!waited->is_oldest_waited_for, XR_ERROR_CALL_ORDER_INVALID,
          "the image that was waited for was not released");
  waited->is_oldest_waited_for = true;
  return XR_SUCCESS;
}

XrResult release_swapchain_image(XrSwapchain swapchain,
                                 const XrSwapchainImageReleaseInfo* release_info) {
  const std::shared_ptr<Swapchain> released = runtime().swapchains.at(swapchain);
  check_if_given(release_info, XR_TYPE_SWAPCHAIN_IMAGE_RELEASE_INFO, "the way to release");
  require(released->is_oldest_waited_for, XR_ERROR_CALL_ORDER_INVALID,
          "no image was acquired and waited for");
  released->last_released = released->acquired.front();
  released->acquired.pop_front();
  released->is_oldest_waited_for = false;
  return XR_SUCCESS;
}

}  // namespace foveola::test::openxr
