#include "renderer/window/drawing/view_geometry.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "renderer/progressive/picture.h"

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

WindowView::WindowView(const DisplayProfile& display, std::optional<double> larger_fov_deg,
                       const IVec2& framebuffer)
    : display_(display),
      first_fov_deg_(larger_fov_deg),
      larger_fov_deg_(larger_fov_deg),
      framebuffer_(framebuffer) {
  update();
}

void WindowView::resize(const IVec2& framebuffer) {
  framebuffer_ = framebuffer;
  update();
}

void WindowView::zoom(double steps) {
  constexpr double step = 1.1;
  const double zoomed = fov_across_deg(std::pow(step, -steps), larger_fov_deg(geometry_));
  larger_fov_deg_ = std::clamp(zoomed, narrowest_fov_deg, widest_fov_deg);
  update();
}

void WindowView::show_first() {
  larger_fov_deg_ = first_fov_deg_.value_or(default_picture_fov_deg);
  update();
}

void WindowView::show_true_angles() {
  larger_fov_deg_.reset();
  update();
}

void WindowView::measure_eyes(bool measures) {
  measures_ = measures;
  update();
}

std::string WindowView::in_words() const {
  const std::string size = fmt::format("view {:.1f} x {:.1f} degrees", geometry_.horizontal_fov_deg,
                                       geometry_.vertical_fov_deg);
  if (!is_free()) {
    return size;
  }
  return larger_fov_deg_ ? fmt::format("{}, {:.2g} times as wide as true", size, times_true())
                         : size + ", true angles";
}

void WindowView::update() {
  true_angles_ = view_geometry(display_, framebuffer_);
  geometry_ = larger_fov_deg_ && !measures_
                  ? view_geometry(display_, framebuffer_, *larger_fov_deg_)
                  : true_angles_;
}

}  // namespace foveola
