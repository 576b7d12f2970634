#include "tests/openxr/runtime/layers.h"

#include <cmath>

#include <fmt/format.h>
#include <glm/trigonometric.hpp>

#include "tests/openxr/runtime/names.h"
#include "tests/openxr/runtime/views.h"

namespace foveola::test::openxr {
namespace {

// What an application may lose by computing in float.
constexpr double tolerance_m = 1e-4;
constexpr double tolerance_deg = 0.01;
constexpr float tolerance_rad = 1e-4F;

bool is_same(const XrPosef& a, const XrPosef& b) {
  return metres_between(pose_of(a), pose_of(b)) <= tolerance_m &&
         degrees_between(pose_of(a), pose_of(b)) <= tolerance_deg;
}

bool is_same(const XrFovf& a, const XrFovf& b) {
  return std::abs(a.angleLeft - b.angleLeft) <= tolerance_rad &&
         std::abs(a.angleRight - b.angleRight) <= tolerance_rad &&
         std::abs(a.angleUp - b.angleUp) <= tolerance_rad &&
         std::abs(a.angleDown - b.angleDown) <= tolerance_rad;
}

[[noreturn]] void refuse_layer(std::size_t view, const std::string& why) {
  throw Refusal(XR_ERROR_LAYER_INVALID, fmt::format("view {} {}", view, why));
}

void check_image(std::size_t view, const XrSwapchainSubImage& image) {
  const std::shared_ptr<Swapchain> swapchain = runtime().swapchains.at(image.swapchain);
  if (!swapchain->last_released) {
    refuse_layer(view, "is of a swapchain of which no image was released");
  }
  if (swapchain->is_oldest_waited_for) {
    refuse_layer(view, "is of a swapchain of which an image is still being drawn on");
  }
  if (swapchain->info.format == GL_DEPTH_COMPONENT24) {
    refuse_layer(view, "is of a swapchain of depths");
  }
  require(image.imageArrayIndex < swapchain->info.arraySize, XR_ERROR_VALIDATION_FAILURE,
          "the swapchain has no such layer");
  const auto& [offset, extent] = image.imageRect;
  const auto reaches = [](std::int32_t from, std::int32_t length) {
    return static_cast<std::int64_t>(from) + length;
  };
  require(offset.x >= 0 && offset.y >= 0 && extent.width > 0 && extent.height > 0 &&
              reaches(offset.x, extent.width) <= swapchain->info.width &&
              reaches(offset.y, extent.height) <= swapchain->info.height,
          XR_ERROR_SWAPCHAIN_RECT_INVALID, "the rectangle is empty, or not inside of the image");
}

void check_view(std::size_t view, const XrCompositionLayerProjectionView& given,
                const std::vector<XrView>& located) {
  checked(&given, XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW, "a view");
  require(is_valid(given.pose), XR_ERROR_POSE_INVALID,
          "a view's pose is not finite, or its quaternion's length is not 1");
  check_image(view, given.subImage);
  const XrView& expected = located[view];
  const XrView& other = located[located.size() - 1 - view];
  if (!is_same(given.pose, expected.pose)) {
    refuse_layer(view,
                 is_same(given.pose, other.pose)
                     ? "has the other eye's pose"
                     : "has another pose than was located for this frame in the layer's space");
  }
  if (!is_same(given.fov, expected.fov)) {
    refuse_layer(view, is_same(given.fov, other.fov) ? "has the other eye's field of view"
                                                     : "has another field of view than its eye");
  }
}

void check_projection(const Session& session, const Frame& frame,
                      const XrCompositionLayerProjection& layer) {
  const std::shared_ptr<Space> space = runtime().spaces.at(layer.space);
  require(layer.viewCount == runtime().script.eyes.size() && layer.views != nullptr,
          XR_ERROR_VALIDATION_FAILURE, "a layer needs two views");
  require(session.times_of_views.contains(frame.display_time), XR_ERROR_LAYER_INVALID,
          "the views were not located for this frame");
  const std::vector<XrView> located = views_in(session, *space, frame.display_time);
  for (std::size_t view = 0; view < located.size(); ++view) {
    check_view(view, layer.views[view], located);
  }
}

nlohmann::json description_of(const XrCompositionLayerProjectionView& view) {
  const auto& [orientation, position] = view.pose;
  const auto degrees = [](float angle) { return glm::degrees(static_cast<double>(angle)); };
  const std::shared_ptr<Swapchain> swapchain = runtime().swapchains.at(view.subImage.swapchain);
  const auto& [offset, extent] = view.subImage.imageRect;
  return {{"position_m", {position.x, position.y, position.z}},
          {"orientation", {orientation.x, orientation.y, orientation.z, orientation.w}},
          {"fov_deg",
           {{"left", degrees(view.fov.angleLeft)},
            {"right", degrees(view.fov.angleRight)},
            {"up", degrees(view.fov.angleUp)},
            {"down", degrees(view.fov.angleDown)}}},
          {"swapchain", swapchain->number},
          {"image", *swapchain->last_released},
          {"array_index", view.subImage.imageArrayIndex},
          {"rect", {offset.x, offset.y, extent.width, extent.height}}};
}

std::string name_of_space(XrSpace handle) {
  const std::shared_ptr<Space> space = runtime().spaces.at(handle);
  return space->action ? space->action->name : short_name(space->reference);
}

}  // namespace

void check_layer(const Session& session, const Frame& frame,
                 const XrCompositionLayerBaseHeader* layer) {
  require(layer != nullptr, XR_ERROR_LAYER_INVALID, "a layer is a null pointer");
  require(layer->type == XR_TYPE_COMPOSITION_LAYER_PROJECTION, XR_ERROR_LAYER_INVALID,
          "there are projection layers only");
  check_projection(session, frame, reinterpret_cast<const XrCompositionLayerProjection&>(*layer));
}

nlohmann::json description_of(const XrCompositionLayerBaseHeader& layer) {
  const auto& projection = reinterpret_cast<const XrCompositionLayerProjection&>(layer);
  nlohmann::json views = nlohmann::json::array();
  for (std::uint32_t i = 0; i < projection.viewCount; ++i) {
    views.push_back(description_of(projection.views[i]));
  }
  return {{"type", "projection"}, {"space", name_of_space(layer.space)}, {"views", views}};
}

}  // namespace foveola::test::openxr
