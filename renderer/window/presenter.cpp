#include "renderer/window/presenter.h"

#include <utility>

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

std::vector<ScreenPlace> screen_places(const ShownFrame& frame) {
  const bool is_headset = frame.views.size() > 1;
  std::vector<ScreenPlace> places;
  for (const ShownView& view : frame.views) {
    places.push_back(
        screen_place(view.part, frame.framebuffer.y, is_headset, view.viewport.lens().axis));
  }
  return places;
}

}  // namespace

std::future<RgbImage> picture_of(ShownFrame& frame) {
  frame.picture = std::make_shared<std::promise<RgbImage>>();
  return frame.picture->get_future();
}

/// What lives on the graphics card.
struct Presenter::Card {
  explicit Card(const PyramidAtlas& atlas) : film(atlas) {}

  void draw(const ShownFrame& frame) {
    film.apply(frame.update);
    if (frame.framebuffer.x <= 0 || frame.framebuffer.y <= 0) {
      return;
    }
    const bool shows_film = !frame.screen || !frame.screen->covers_picture;
    std::vector<WindowPart> parts;
    for (const ShownView& view : frame.views) {
      if (shows_film) {
        renderer.draw(film, view.viewport, view.part, frame.look, frame.overlays);
      }
      parts.push_back(view.part);
    }
    glViewport(0, 0, frame.framebuffer.x, frame.framebuffer.y);
    if (frame.screen) {
      text.draw(frame.framebuffer, screen_places(frame), *frame.screen);
    }
    text.draw(frame.framebuffer, parts, frame.panels);
    if (frame.picture) {
      frame.picture->set_value(read_picture(frame.framebuffer));
    }
  }

  FilmTexture film;
  ViewRenderer renderer;
  TextOverlay text;
};

Presenter::Presenter(Window& window, const PyramidAtlas& atlas, const Clock& clock)
    : window_(&window), clock_(&clock) {
  thread_ = std::jthread([this, atlas](const std::stop_token& stop) { run(stop, atlas); });
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

void Presenter::run(const std::stop_token& stop, const PyramidAtlas& atlas) {
  try {
    window_->make_current();
    Card card(atlas);
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
