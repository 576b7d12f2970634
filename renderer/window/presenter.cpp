#include "renderer/window/presenter.h"

#include <utility>

#include "renderer/window/picture_texture.h"

namespace foveola {
namespace {

std::string graphics_name() {
  const auto text = [](GLenum name) {
    const GLubyte* value = glGetString(name);
    return value != nullptr ? std::string(reinterpret_cast<const char*>(value)) : std::string();
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

/// The picture in the buffer that is drawn to.
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

void fill(const WindowPart& part, float grey) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(part.origin.x, part.origin.y, part.size.x, part.size.y);
  glClearColor(grey, grey, grey, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
}

}  // namespace

std::future<RgbImage> picture_of(ShownFrame& frame) {
  frame.picture = std::make_shared<std::promise<RgbImage>>();
  return frame.picture->get_future();
}

/// What lives on the graphics card.
struct Presenter::Card {
  void draw(const ShownFrame& frame) {
    update_film(frame);
    if (frame.framebuffer.x <= 0 || frame.framebuffer.y <= 0) {
      return;
    }
    const bool shows_film = !frame.screen || !frame.screen->covers_picture;
    if (shows_film) {
      draw_film(frame);
    }
    glViewport(0, 0, frame.framebuffer.x, frame.framebuffer.y);
    if (frame.picture && frame.picture_is_bare) {
      frame.picture->set_value(read_picture(frame.framebuffer));
    }
    text.draw(frame.framebuffer, frame.views,
              {.marks = shows_film ? &frame.overlays : nullptr,
               .screen = frame.screen ? &*frame.screen : nullptr,
               .panels = frame.panels});
    if (frame.patch) {
      fill(*frame.patch, frame.is_patch_lit ? 1.0F : 0.0F);
    }
    if (frame.picture && !frame.picture_is_bare) {
      frame.picture->set_value(read_picture(frame.framebuffer));
    }
  }

  void update_film(const ShownFrame& frame) {
    if (frame.atlas == nullptr) {
      return;
    }
    if (!film || film->atlas().size() != frame.atlas->size()) {
      film.reset();
      film.emplace(*frame.atlas);
    }
    film->apply(frame.update);
  }

  void draw_film(const ShownFrame& frame) {
    if (frame.pictures.empty() && !film) {
      glClear(GL_COLOR_BUFFER_BIT);
      return;
    }
    for (std::size_t i = 0; i < frame.views.size(); ++i) {
      const ShownView& view = frame.views[i];
      if (!frame.pictures.empty()) {
        picture.draw(*frame.pictures[i], view.part);
      } else {
        renderer.draw(*film, view.viewport, view.part, frame.look);
      }
    }
  }

  std::optional<FilmTexture> film;  ///< once there is one to draw
  ViewRenderer renderer;
  PictureTexture picture;
  TextOverlay text;
};

Presenter::Presenter(Window& window, const Clock& clock) : window_(&window), clock_(&clock) {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  std::unique_lock lock(mutex_);
  wait_for(is_ready_, lock);
}

Presenter::~Presenter() = default;

void Presenter::draw(ShownFrame frame) {
  std::unique_lock lock(mutex_);
  wait_for(is_ready_, lock);
  is_ready_ = false;
  is_drawn_ = false;
  frame_ = std::move(frame);
  changed_.notify_all();
  wait_for(is_drawn_, lock);
}

Nanoseconds Presenter::wait_until_shown() {
  std::unique_lock lock(mutex_);
  wait_for(is_ready_, lock);
  return shown_;
}

void Presenter::wait_for(const bool& flag, std::unique_lock<std::mutex>& lock) {
  changed_.wait(lock, [&] { return flag || fault_; });
  if (fault_) {
    std::rethrow_exception(fault_);
  }
}

void Presenter::run(const std::stop_token& stop) {
  try {
    window_->make_current();
    Card card;
    graphics_ = graphics_name();
    serve(stop, card);
  } catch (...) {
    fail(std::current_exception());
  }
  window_->release();
}

void Presenter::serve(const std::stop_token& stop, Card& card) {
  std::unique_lock lock(mutex_);
  while (true) {
    is_ready_ = true;
    changed_.notify_all();
    if (!changed_.wait(lock, stop, [this] { return frame_.has_value(); })) {
      return;
    }
    const ShownFrame frame = *std::exchange(frame_, std::nullopt);
    lock.unlock();
    card.draw(frame);
    glFinish();
    lock.lock();
    is_drawn_ = true;
    changed_.notify_all();
    lock.unlock();
    if (frame.framebuffer.x > 0 && frame.framebuffer.y > 0) {
      window_->swap();
    }
    lock.lock();
    shown_ = clock_->now();
  }
}

void Presenter::fail(std::exception_ptr fault) {
  const std::scoped_lock lock(mutex_);
  fault_ = std::move(fault);
  changed_.notify_all();
}

}  // namespace foveola
