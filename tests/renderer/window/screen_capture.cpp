#include "tests/renderer/window/screen_capture.h"

#include <cstdlib>
#include <filesystem>

#include "renderer/base/work/parallel.h"
#include "renderer/window/live/live_preview.h"
#include "tests/renderer/window/patterned_film.h"

namespace foveola::test {
namespace {

std::vector<ShownView> views_of(const WindowCase& window, const IVec2& framebuffer) {
  const Quat head = head_orientation({});
  const auto view = [&](int x, int width) {
    return ShownView{
        .viewport = Viewport(head, radians(100.0), radians(100.0)),
        .part = {.origin = {x, 0}, .size = {width, framebuffer.y}},
        .straight_ahead = window.is_headset ? std::optional(Vec2(0.5F)) : std::nullopt};
  };
  const int half = framebuffer.x / 2;
  return window.is_headset ? std::vector{view(0, half), view(half, half)}
                           : std::vector{view(0, framebuffer.x)};
}

void fill_with_white(EquirectFilm& film) {
  std::vector<Vec2> images;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      images.push_back((Vec2(x, y) + 0.5F) / Vec2(film.width(), film.height()));
    }
  }
  add_samples(film, images, std::vector<Rgb>(images.size(), Rgb(1.0F)), Workers(1));
}

}  // namespace

ScreenCapture::ScreenCapture(const WindowCase& window) : window_case_(window) {
  fill_with_white(film_);
}

RgbImage ScreenCapture::capture(const std::optional<ScreenPage>& screen, const IVec2& framebuffer) {
  return draw({.framebuffer = framebuffer, .screen = screen});
}

RgbImage ScreenCapture::capture(const ViewOverlays& overlays) {
  return draw({.framebuffer = window_case_.size, .overlays = overlays});
}

RgbImage ScreenCapture::draw(ShownFrame frame) {
  const std::vector<ShownView> views = views_of(window_case_, frame.framebuffer);
  std::vector<Viewport> viewports;
  for (const ShownView& view : views) {
    viewports.push_back(view.viewport);
  }
  frame.atlas = &mirror_.atlas();
  frame.update = mirror_.collect(film_, viewports, film_.levels());
  frame.views = views;
  auto picture = picture_of(frame);
  presenter_.draw(std::move(frame));
  return picture.get();
}

void keep_for_people(const std::string& name, const RgbImage& picture) {
  if (const char* folder = std::getenv("FOVEOLA_SCREENS")) {
    std::filesystem::create_directories(folder);
    write_display_picture(std::filesystem::path(folder) / (name + ".png"), picture);
  }
}

int strangers_in_margin(const RgbImage& picture, Ink ink) {
  const int margin_px = picture.height / 100;
  int strangers = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const bool is_inside = x >= margin_px && y >= margin_px && x < picture.width - margin_px &&
                             y < picture.height - margin_px;
      strangers += !is_inside && !is_ink(picture.at(x, y), ink) ? 1 : 0;
    }
  }
  return strangers;
}

bool is_ink(const Rgb& color, Ink ink) {
  return max_component(glm::abs(color - color_of(ink))) < 1.0F / 255.0F;
}

}  // namespace foveola::test
