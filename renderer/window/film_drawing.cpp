#include "renderer/window/film_drawing.h"

#include <algorithm>
#include <array>
#include <utility>

#include "renderer/window/head_frame.h"

namespace foveola {
namespace {

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

FilmDrawer usual_drawer(std::string_view graphics) {
  constexpr std::array<std::string_view, 4> software = {"llvmpipe", "softpipe", "SWR",
                                                        "Software Rasterizer"};
  const bool is_software = std::any_of(
      software.begin(), software.end(),
      [&](std::string_view name) { return graphics.find(name) != std::string_view::npos; });
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
    // The card may still have another film of that size.
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

}  // namespace foveola
