#include "study/person/devices/session_display.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "renderer/window/drawing/slow_drawing.h"

namespace foveola::study {

SessionDisplay::SessionDisplay(Presenter& presenter, const DisplayProfile& profile,
                               const IVec2& framebuffer, const Clock& clock)
    : clock_(&clock),
      geometry_(view_geometry(profile, framebuffer)),
      profile_(profile),
      area_{.framebuffer = framebuffer},
      refresh_(profile.refresh_rate_hz),
      presenter_(&presenter),
      frame_budget_(frame_budget_for(presenter.film_drawer())) {}

void SessionDisplay::resize(const IVec2& framebuffer) {
  area_.framebuffer = framebuffer;
  if (area_.is_seen()) {
    geometry_.parts = view_geometry(profile_, framebuffer).parts;
  }
}

void SessionDisplay::draw(SessionPicture picture) {
  ShownFrame frame = head_frame(area_, geometry_, picture.head, picture.look);
  frame.late_turn_rad = presenter_->late_turn_rad();
  if (area_.is_seen()) {
    if (drawing_) {
      drawing_->bring_up_to_date(frame);
    }
    frame.overlays = std::move(picture.overlays);
    frame.screen = std::move(picture.screen);
    if (profile_.timing_patch) {
      frame.patch = part_of(*profile_.timing_patch, area_.framebuffer);
      frame.is_patch_lit = picture.lights_patch;
    }
    if (const auto file = std::exchange(picture_file_, std::nullopt)) {
      pictures_.write_privately(*file, picture_of(frame));
    } else if (std::exchange(keeps_pixels_, false)) {
      pixels_ = picture_of(frame);
    }
  }
  presenter_->draw(std::move(frame));
}

std::optional<RgbImage> SessionDisplay::take_pixels() {
  return pixels_.valid() ? std::optional(pixels_.get()) : std::nullopt;
}

std::optional<Nanoseconds> SessionDisplay::wait_until_shown() {
  const Nanoseconds shown = presenter_->wait_until_shown();
  return area_.is_seen() ? std::optional(shown) : std::nullopt;
}

Nanoseconds SessionDisplay::show(SessionPicture picture) {
  std::this_thread::sleep_until(std::chrono::steady_clock::time_point(next_frame_));
  const Nanoseconds start = clock_->now();
  draw(std::move(picture));
  const std::optional<Nanoseconds> shown = wait_until_shown();
  if (shown) {
    refresh_.swap_completed(*shown);
  }
  // Sleeping might miss a refresh; the wait for refreshes limits the rate already.
  const bool waits = shown && !refresh_.is_unsynchronised();
  next_frame_ = waits ? start : start + refresh_.interval();
  return shown.value_or(clock_->now());
}

void SessionDisplay::show_film(const EquirectFilm& film, const Workers& workers) {
  drawing_.emplace(film, presenter_->film_drawer(), workers);
}

}  // namespace foveola::study
