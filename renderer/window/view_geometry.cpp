#include "renderer/window/view_geometry.h"

#include <algorithm>
#include <cmath>

namespace foveola {
namespace {

ViewGeometry pane_at_a_distance(const DisplayProfile& display, const IVec2& framebuffer) {
  const auto fov_deg = [&](double side_m) {
    return degrees(2.0 * std::atan(0.5 * side_m / display.viewing_distance_m));
  };
  return {.horizontal_fov_deg = fov_deg(display.width_m * framebuffer.x / display.width_px),
          .vertical_fov_deg = fov_deg(display.height_m * framebuffer.y / display.height_px),
          .parts = {{.origin = IVec2(0), .size = framebuffer}}};
}

ViewGeometry view_for_each_eye(const DisplayProfile& display, const IVec2& framebuffer) {
  const IVec2 half(framebuffer.x / 2, framebuffer.y);
  return {
      .horizontal_fov_deg = display.horizontal_fov_deg,
      .vertical_fov_deg = display.vertical_fov_deg,
      .lens = display.lens.value_or(RadialLens{}),
      .parts = {{.origin = IVec2(0), .size = half}, {.origin = IVec2(half.x, 0), .size = half}}};
}

ViewGeometry view_of_head(const DisplayProfile& display, const IVec2& framebuffer) {
  return {.horizontal_fov_deg = display.horizontal_fov_deg,
          .vertical_fov_deg = display.vertical_fov_deg,
          .lens = display.lens.value_or(RadialLens{}),
          .seen = display.seen,
          .parts = {{.origin = IVec2(0), .size = framebuffer}}};
}

}  // namespace

ViewGeometry view_geometry(const DisplayProfile& display, const IVec2& framebuffer) {
  switch (display.kind) {
    case DisplayKind::headset:
      return view_for_each_eye(display, framebuffer);
    case DisplayKind::monitor:
      return pane_at_a_distance(display, framebuffer);
    case DisplayKind::openxr:
      break;
  }
  return view_of_head(display, framebuffer);
}

ViewGeometry view_geometry(const DisplayProfile& display, const IVec2& framebuffer,
                           double larger_fov_deg) {
  ViewGeometry geometry = view_geometry(display, framebuffer);
  if (display.kind == DisplayKind::monitor) {
    const double larger_px = std::max(framebuffer.x, framebuffer.y);
    geometry.horizontal_fov_deg = fov_across_deg(framebuffer.x / larger_px, larger_fov_deg);
    geometry.vertical_fov_deg = fov_across_deg(framebuffer.y / larger_px, larger_fov_deg);
  }
  return geometry;
}

double larger_fov_deg(const ViewGeometry& geometry) {
  return std::max(geometry.horizontal_fov_deg, geometry.vertical_fov_deg);
}

double widening(const ViewGeometry& geometry, const ViewGeometry& true_angles) {
  const auto half_width = [](const ViewGeometry& one) {
    return std::tan(radians(0.5 * one.horizontal_fov_deg));
  };
  return half_width(geometry) / half_width(true_angles);
}

std::vector<Viewport> viewports_of(const ViewGeometry& geometry, const Quat& head) {
  std::vector<Viewport> viewports;
  for (std::size_t i = 0; i < geometry.parts.size(); ++i) {
    viewports.emplace_back(head * geometry.turned, radians(geometry.horizontal_fov_deg),
                           radians(geometry.vertical_fov_deg),
                           i == 0 ? geometry.lens : mirrored(geometry.lens));
  }
  return viewports;
}

Vec3 direction_below(const ViewGeometry& geometry, const DVec2& place, int framebuffer_height) {
  const auto right_of = [&](const WindowPart& part) { return place.x < part.origin.x; };
  const auto after = std::find_if(geometry.parts.begin() + 1, geometry.parts.end(), right_of);
  const std::size_t index = static_cast<std::size_t>(after - geometry.parts.begin()) - 1;
  const WindowPart& part = geometry.parts[index];
  const double top = framebuffer_height - part.origin.y - part.size.y;
  const DVec2 plane = (place - DVec2(part.origin.x, top)) / DVec2(part.size);
  return viewports_of(geometry, head_orientation({}))[index].direction(Vec2(plane));
}

}  // namespace foveola
