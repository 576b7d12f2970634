#include "renderer/window/drawing/frame_painter.h"

#include <array>

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

void fill(const WindowPart& part, float grey) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(part.origin.x, part.origin.y, part.size.x, part.size.y);
  glClearColor(grey, grey, grey, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
}

bool shows_film(const ShownFrame& frame) { return !frame.screen || !frame.screen->covers_picture; }

}  // namespace

std::string graphics_name() {
  const auto text = [](GLenum name) {
    const GLubyte* value = glGetString(name);
    return value != nullptr ? std::string(reinterpret_cast<const char*>(value)) : std::string();
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

void require_drawable(const IVec2& window_px) {
  std::array<GLint, 2> largest{};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, largest.data());
  if (window_px.x > largest[0] || window_px.y > largest[1]) {
    throw Error("window",
                fmt::format("{} x {} pixels are more than OpenGL draws here, {} x {}", window_px.x,
                            window_px.y, largest[0], largest[1]),
                "make it smaller");
  }
}

RgbImage read_picture(const IVec2& size) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size.x) * size.y * 3);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
  RgbImage picture(size.x, size.y);
  for (int y = 0; y < size.y; ++y) {
    const std::uint8_t* row = &bytes[static_cast<std::size_t>(size.y - 1 - y) * size.x * 3];
    for (int x = 0; x < size.x; ++x) {
      picture.at(x, y) = Rgb(row[3 * x], row[3 * x + 1], row[3 * x + 2]) / 255.0F;
    }
  }
  return picture;
}

void FramePainter::draw(const ShownFrame& frame) {
  update_film(frame);
  if (frame.framebuffer.x <= 0 || frame.framebuffer.y <= 0) {
    return;
  }
  if (shows_film(frame)) {
    draw_films(frame);
  }
  glViewport(0, 0, frame.framebuffer.x, frame.framebuffer.y);
  if (frame.picture && frame.picture_is_bare) {
    frame.picture->set_value(read_picture(frame.framebuffer));
  }
  draw_over(frame, frame.framebuffer, frame.views, frame.panels);
  if (frame.patch) {
    fill(*frame.patch, frame.is_patch_lit ? 1.0F : 0.0F);
  }
  if (frame.picture && !frame.picture_is_bare) {
    frame.picture->set_value(read_picture(frame.framebuffer));
  }
}

void FramePainter::update_film(const ShownFrame& frame) {
  if (frame.atlas == nullptr) {
    return;
  }
  if (!film_ || film_->atlas().size() != frame.atlas->size()) {
    film_.reset();
    film_.emplace(*frame.atlas);
  }
  film_->apply(frame.update);
}

void FramePainter::draw_films(const ShownFrame& frame) {
  if (frame.pictures.empty() && !film_) {
    glClear(GL_COLOR_BUFFER_BIT);
    return;
  }
  for (std::size_t i = 0; i < frame.views.size(); ++i) {
    if (!frame.pictures.empty()) {
      picture_.draw(*frame.pictures[i], frame.views[i].part);
    } else {
      draw_film(frame, frame.views[i]);
    }
  }
}

void FramePainter::draw_film(const ShownFrame& frame, const ShownView& view) {
  if (film_ && shows_film(frame)) {
    renderer_.draw(*film_, view.viewport, view.part, frame.look);
  }
}

void FramePainter::draw_over(const ShownFrame& frame, const IVec2& framebuffer,
                             std::span<const ShownView> views, std::span<const TextPanel> panels) {
  text_.draw(framebuffer, views,
             {.marks = shows_film(frame) ? &frame.overlays : nullptr,
              .screen = frame.screen ? &*frame.screen : nullptr,
              .panels = panels});
}

}  // namespace foveola
