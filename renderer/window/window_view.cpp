#include "renderer/window/window_view.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "renderer/progressive/picture.h"

namespace foveola {

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
  larger_fov_deg_ = first_fov_deg_.value_or(usual_picture_fov_deg);
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
