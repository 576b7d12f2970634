#include "study/person/session_display.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "renderer/window/live_preview.h"

namespace foveola::study {
namespace {

/// Pages alone need no film; this one costs nothing.
constexpr IVec2 smallest_film{64, 32};

}  // namespace

SessionDisplay::SessionDisplay(Window& window, const DisplayProfile& profile,
                               const IVec2& framebuffer, const Clock& clock)
    : window_(&window),
      clock_(&clock),
      geometry_(view_geometry(profile, framebuffer)),
      profile_(profile),
      framebuffer_(framebuffer),
      refresh_(profile.refresh_rate_hz) {}

SessionDisplay::~SessionDisplay() {
  for (std::future<void>& written : pictures_being_written_) {
    written.wait();
  }
}

void SessionDisplay::resize(const IVec2& framebuffer) {
  framebuffer_ = framebuffer;
  if (is_seen()) {
    geometry_.parts = view_geometry(profile_, framebuffer).parts;
  }
}

bool SessionDisplay::is_seen() const {
  return !is_hidden_ && framebuffer_.x >= 2 && framebuffer_.y >= 1;
}

void SessionDisplay::draw(SessionPicture picture) {
  if (!presenter_) {
    film_size_ = smallest_film;
    presenter_ = std::make_unique<Presenter>(
        *window_, PyramidAtlas(smallest_film.x, smallest_film.y), *clock_);
  }
  ShownFrame frame;
  const std::vector<Viewport> viewports = viewports_of(geometry_, picture.head);
  for (std::size_t i = 0; i < viewports.size(); ++i) {
    frame.views.push_back({.viewport = viewports[i], .part = geometry_.parts[i]});
  }
  if (is_seen()) {
    frame.framebuffer = framebuffer_;
    frame.update = update_for(picture.look, viewports);
    frame.look = picture.look;
    frame.overlays = std::move(picture.overlays);
    frame.screen = std::move(picture.screen);
    if (const auto file = std::exchange(picture_file_, std::nullopt)) {
      frame.picture = std::make_shared<std::promise<RgbImage>>();
      pictures_being_written_.push_back(std::async(
          std::launch::async, [file = *file, drawn = frame.picture->get_future()]() mutable {
            write_display_picture(file, drawn.get());
          }));
    }
  }
  presenter_->draw(std::move(frame));
}

std::optional<Nanoseconds> SessionDisplay::wait_until_shown() {
  const Nanoseconds shown = presenter_->wait_until_shown();
  return is_seen() ? std::optional(shown) : std::nullopt;
}

Nanoseconds SessionDisplay::show(SessionPicture picture) {
  std::this_thread::sleep_until(std::chrono::steady_clock::time_point(next_frame_));
  const Nanoseconds start = clock_->now();
  draw(std::move(picture));
  const std::optional<Nanoseconds> shown = wait_until_shown();
  if (shown) {
    refresh_.swap_completed(*shown);
  }
  // Who waits for refreshes anyway must not miss one by sleeping.
  const bool waits = shown && !refresh_.is_unsynchronised();
  next_frame_ = waits ? start : start + refresh_.interval();
  return shown.value_or(clock_->now());
}

void SessionDisplay::show_film(const EquirectFilm& film) {
  film_ = &film;
  mirror_.emplace(film);
  first_update_.clear();
  if (presenter_ && film_size_ == IVec2(film.width(), film.height())) {
    const IVec2& size = mirror_->atlas().size();
    first_update_.push_back({.width = static_cast<std::uint16_t>(size.x),
                             .height = static_cast<std::uint16_t>(size.y)});
  } else {
    film_size_ = {film.width(), film.height()};
    presenter_.reset();
    presenter_ = std::make_unique<Presenter>(*window_, mirror_->atlas(), *clock_);
  }
}

FilmUpdate SessionDisplay::update_for(const ViewLook& look,
                                      const std::vector<Viewport>& viewports) {
  if (film_ == nullptr) {
    return {};
  }
  const int levels =
      look.fill_unsampled
          ? film_->levels()
          : levels_shown(viewports.front(), geometry_.parts.front().size, film_->height());
  FilmUpdate update = std::exchange(first_update_, {});
  const FilmUpdate changes = mirror_->collect(*film_, viewports, levels);
  update.insert(update.end(), changes.begin(), changes.end());
  return update;
}

}  // namespace foveola::study
