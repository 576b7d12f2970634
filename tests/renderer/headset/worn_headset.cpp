#include "tests/renderer/headset/worn_headset.h"

#include <algorithm>
#include <iterator>

#include "renderer/window/drawing/film_drawing.h"
#include "tests/renderer/window/patterned_film.h"
#include "tests/waiting.h"

namespace foveola::test {

WornHeadset::WornHeadset() { paint_pattern(film_, workers_); }

ShownFrame WornHeadset::frame() {
  const HeadsetFacts& facts = presenter_.facts();
  const IVec2 eye_px = facts.eye_px[0];
  const ViewGeometry geometry{.horizontal_fov_deg = facts.both.horizontal_deg,
                              .vertical_fov_deg = facts.both.vertical_deg,
                              .lens = facts.both.lens,
                              .parts = {{.origin = IVec2(0), .size = eye_px}}};
  HeadsetHead head(presenter_.motion());
  ShownFrame frame =
      head_frame({.framebuffer = eye_px}, geometry, head.pose(now()).orientation(), {});
  frame.late_turn_rad = presenter_.late_turn_rad();
  drawing_.bring_up_to_date(frame);
  return frame;
}

void WornHeadset::show(const std::optional<ScreenPage>& page) {
  ShownFrame shown = frame();
  shown.screen = page;
  presenter_.draw(std::move(shown));
  presenter_.wait_until_shown();
}

RgbImage WornHeadset::shown_picture() {
  ShownFrame asking = frame();
  std::future<RgbImage> picture = picture_of(asking);
  presenter_.draw(std::move(asking));
  presenter_.wait_until_shown();
  return picture.get();
}

std::optional<WindowEvent> WornHeadset::next_event() {
  std::ranges::move(events_.take(), std::back_inserter(unseen_events_));
  if (unseen_events_.empty()) {
    return std::nullopt;
  }
  WindowEvent event = std::move(unseen_events_.front());
  unseen_events_.pop_front();
  return event;
}

std::vector<std::pair<int, bool>> WornHeadset::keys(std::size_t count) {
  std::vector<std::pair<int, bool>> moved;
  wait_until("keys", [&] {
    while (moved.size() < count) {
      const std::optional<WindowEvent> event = next_event();
      if (!event) {
        return false;
      }
      if (const auto* key = std::get_if<KeyMoved>(&event->what)) {
        moved.emplace_back(key->key, key->is_down);
      }
    }
    return true;
  });
  return moved;
}

std::vector<HeadsetChange> WornHeadset::changes_until(HeadsetChange last) {
  std::vector<HeadsetChange> changes;
  wait_until("a change of the headset", [&] {
    while (const std::optional<WindowEvent> event = next_event()) {
      if (const auto* changed = std::get_if<HeadsetChanged>(&event->what)) {
        changes.push_back(changed->change);
        if (changed->change == last) {
          return true;
        }
      }
    }
    return false;
  });
  return changes;
}

}  // namespace foveola::test
