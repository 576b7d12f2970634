#include "renderer/window/drawing/film_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "renderer/base/transformed.h"

namespace foveola {
namespace {

/// The view of the same head, wider by by_rad on each side, without a lens' distortion.
Viewport widened(const Viewport& view, double by_rad) {
  constexpr double farthest_rad = radians(85.0);
  const auto side = [&](double tangent) {
    return std::tan(std::min(std::atan(tangent) + by_rad, farthest_rad));
  };
  const DVec2 low = 2.0 * DVec2(view.lens().axis) * DVec2(view.half_size());
  const DVec2 high = 2.0 * DVec2(view.half_size()) - low;
  const DVec2 wide_low(side(low.x), side(low.y));
  const DVec2 size = wide_low + DVec2(side(high.x), side(high.y));
  return {view.head(),
          2.0 * std::atan(0.5 * size.x),
          2.0 * std::atan(0.5 * size.y),
          {.axis = Vec2(wide_low / size)}};
}

ViewImage view_image(const ShownView& view, const ViewLook& look) {
  return {.width = view.part.size.x,
          .height = view.part.size.y,
          .unsampled = look.fill_unsampled ? UnsampledPixels::filled : UnsampledPixels::black,
          .exposure_stops = look.exposure_stops,
          .curve = look.curve};
}

bool have_same_size(const ViewImage& a, const ViewImage& b) {
  return a.width == b.width && a.height == b.height;
}

}  // namespace

FilmDrawer default_drawer(std::string_view graphics) {
  constexpr std::array<std::string_view, 4> software = {"llvmpipe", "softpipe", "SWR",
                                                        "Software Rasterizer"};
  const bool is_software = std::ranges::any_of(software, [&](std::string_view name) {
    return graphics.find(name) != std::string_view::npos;
  });
  return is_software ? FilmDrawer::processor : FilmDrawer::graphics_card;
}

FrameBudget frame_budget_for(FilmDrawer drawer) {
  return FrameBudget(drawer == FilmDrawer::processor ? FrameBudget::shared_processor_share
                                                     : FrameBudget::least_share);
}

FilmDrawing::FilmDrawing(const EquirectFilm& film, FilmDrawer drawer, const Workers& workers)
    : film_(&film), workers_(&workers) {
  if (drawer == FilmDrawer::graphics_card) {
    drawer_.emplace<FilmMirror>(film);
  }
}

void FilmDrawing::bring_up_to_date(ShownFrame& frame) {
  if (auto* mirror = std::get_if<FilmMirror>(&drawer_)) {
    update_card(frame, *mirror);
  } else {
    resample(frame, std::get<ProcessorViews>(drawer_));
  }
}

void FilmDrawing::update_card(ShownFrame& frame, FilmMirror& mirror) {
  frame.atlas = &mirror.atlas();
  frame.update = update_for(frame, *film_, mirror);
  if (std::exchange(is_new_, false)) {
    // The card may still hold another film of that size.
    const IVec2& size = mirror.atlas().size();
    frame.update.insert(frame.update.begin(), {.width = static_cast<std::uint16_t>(size.x),
                                               .height = static_cast<std::uint16_t>(size.y)});
  }
}

void FilmDrawing::resample(ShownFrame& frame, ProcessorViews& views) const {
  views.resize(frame.views.size());
  frame.pictures.clear();
  for (std::size_t i = 0; i < views.size(); ++i) {
    const ViewImage settings = view_image(frame.views[i], frame.look);
    ProcessorView& view = views[i];
    if (!view.resampler || !have_same_size(view.settings, settings)) {
      view.resampler = std::make_unique<DisplayResampler>(*film_, settings);
    } else if (view.settings != settings) {
      view.resampler->change_look(settings);
    }
    view.settings = settings;
    frame.pictures.push_back(&view.resampler->show(frame.views[i].viewport, *workers_));
  }
}

ShownFrame head_frame(const WindowArea& window, const ViewGeometry& geometry, const Quat& head,
                      const ViewLook& look) {
  ShownFrame frame{.framebuffer = window.is_seen() ? window.framebuffer : IVec2(0), .look = look};
  const std::vector<Viewport> viewports = viewports_of(geometry, head);
  for (std::size_t i = 0; i < viewports.size(); ++i) {
    frame.views.push_back({.viewport = viewports[i], .part = geometry.parts[i]});
    if (viewports.size() > 1) {
      frame.views.back().straight_ahead = viewports[i].lens().axis;
    }
  }
  return frame;
}

FilmUpdate update_for(const ShownFrame& frame, const EquirectFilm& film, FilmMirror& mirror) {
  const std::vector<Viewport> viewports = transformed(frame.views, [&](const ShownView& view) {
    return frame.late_turn_rad > 0.0 ? widened(view.viewport, frame.late_turn_rad) : view.viewport;
  });
  const int levels = frame.look.fill_unsampled
                         ? film.levels()
                         : levels_shown(frame.views.front().viewport, frame.views.front().part.size,
                                        film.height());
  return mirror.collect(film, viewports, levels);
}

}  // namespace foveola
