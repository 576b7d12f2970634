#include "renderer/headset/headset_connection.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <epoxy/gl.h>

#include "renderer/headset/glx_session.h"

namespace foveola {

WindowPart largest_part(const IVec2& window, const IVec2& picture) {
  const double scale = std::min(static_cast<double>(window.x) / picture.x,
                                static_cast<double>(window.y) / picture.y);
  const IVec2 size(std::lround(scale * picture.x), std::lround(scale * picture.y));
  return {.origin = (window - size) / 2, .size = size};
}

void HeadsetMirror::begin_frame(Nanoseconds now) {
  is_due_ = now >= next_;
  if (is_due_) {
    next_ = now + interval;
  }
}

void HeadsetMirror::copy(const ShownView& view) {
  if (!is_due_) {
    return;
  }
  window_px_ = current_drawable_px();
  const WindowPart to = largest_part(window_px_, view.part.size);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glBlitFramebuffer(0, 0, view.part.size.x, view.part.size.y, to.origin.x, to.origin.y,
                    to.origin.x + to.size.x, to.origin.y + to.size.y, GL_COLOR_BUFFER_BIT,
                    GL_LINEAR);
  copied_ = {.viewport = view.viewport, .part = to};
}

void HeadsetMirror::show(const std::optional<Vec3>& gaze, std::span<const TextPanel> panels,
                         FramePainter& painter) {
  const std::optional<ShownView> view = std::exchange(copied_, std::nullopt);
  if (!view) {
    return;
  }
  glViewport(0, 0, window_px_.x, window_px_.y);
  ShownFrame over;
  if (gaze) {
    over.overlays.gaze = *gaze;
    over.overlays.shows_gaze = true;
  }
  painter.draw_over(over, window_px_, {&*view, 1}, panels);
  window_->swap();
}

HeadsetConnection::HeadsetConnection()
    : session_(instance_),
      inputs_(instance_, session_.handle()),
      images_{EyeImages(instance_, session_.handle(), 0),
              EyeImages(instance_, session_.handle(), 1)},
      hidden_{HiddenArea(instance_, session_.handle(), 0),
              HiddenArea(instance_, session_.handle(), 1)} {}

void HeadsetConnection::ask(Nanoseconds now, const XrPlannedFrame& planned, HeadsetMotion& motion,
                            std::vector<WindowEvent>& keys) {
  inputs_.update(now, keys);
  std::optional<GazeSample> sample;
  if (const std::optional<XrSpace> gaze = inputs_.gaze_space()) {
    sample = gaze_times_.sample_of(session_.gaze_at(now, *gaze));
  }
  const auto tell_of_head = [&](Nanoseconds time, XrTime xr_time) {
    if (const std::optional<Quat> head = session_.head_at(xr_time)) {
      motion.head_was(time, *head);
    }
  };
  // In order of time: the gaze's, now, and the display's.
  if (sample) {
    tell_of_head(sample->time, instance_.xr_time(sample->time));
    motion.gaze_came(*sample);
  }
  tell_of_head(now, instance_.xr_time(now));
  tell_of_head(instance_.steady_time(planned.display_time), planned.display_time);
}

std::optional<HeadsetFacts> HeadsetConnection::facts(const XrPlannedFrame& planned,
                                                     Nanoseconds asked) const {
  const std::optional<std::array<XrView, 2>> eyes = session_.eyes_at(planned.display_time);
  const std::optional<Quat> head = session_.head_at(planned.display_time);
  if (!eyes || !head) {
    return std::nullopt;
  }
  HeadsetFacts facts{.runtime = instance_.runtime(),
                     .headset = instance_.headset(),
                     .has_eye_tracker = instance_.has_eye_tracker(),
                     .eye_px = instance_.eye_px(),
                     .both = field_of_view_of_both(*eyes, *head),
                     .refresh_rate_hz = 1.0 / seconds(planned.interval),
                     .display_delay = instance_.steady_time(planned.display_time) - asked};
  for (std::size_t eye = 0; eye < eyes->size(); ++eye) {
    facts.eyes[eye] = field_of_view_of((*eyes)[eye].fov);
    facts.head_from_eyes[eye] = glm::conjugate(*head) * orientation_of((*eyes)[eye].pose);
  }
  facts.both.seen =
      seen_by_eyes(*eyes, *head, facts.both, {hidden_[0].triangles(), hidden_[1].triangles()});
  return facts;
}

void HeadsetConnection::follow_events(std::vector<HeadsetChange>& changes) {
  session_.follow_events(changes);
  if (session_.take_mask_change()) {
    hidden_ = {HiddenArea(instance_, session_.handle(), 0),
               HiddenArea(instance_, session_.handle(), 1)};
  }
}

void HeadsetConnection::show(const XrPlannedFrame& planned, ShownFrame& shown,
                             const Quat& world_from_room, FramePainter& painter,
                             HeadsetMirror& mirror) {
  session_.begin_frame();
  std::array<XrCompositionLayerProjectionView, 2> views;
  const std::optional<std::array<XrView, 2>> eyes =
      planned.is_drawn ? session_.eyes_at(planned.display_time) : std::nullopt;
  const std::optional<Quat> head = eyes ? session_.head_at(planned.display_time) : std::nullopt;
  if (!head) {
    session_.end_frame(planned, {});
    return;
  }
  for (std::size_t eye = 0; eye < views.size(); ++eye) {
    draw(eye, (*eyes)[eye].fov,
         {.viewport = viewport_of((*eyes)[eye], world_from_room),
          .part = {.origin = IVec2(0), .size = images_[eye].size_px()},
          .straight_ahead = std::nullopt,
          .part_from_canvas = part_from_canvas(*eyes, eye, *head, page_distance_m)},
         shown, painter, mirror);
    views[eye] = {XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW};
    views[eye].pose = (*eyes)[eye].pose;
    views[eye].fov = (*eyes)[eye].fov;
    views[eye].subImage = images_[eye].sub_image();
  }
  session_.end_frame(planned, views);
}

/// Except where its lens hides it.
void HeadsetConnection::draw_film(std::size_t eye, const XrFovf& fov, const ShownView& view,
                                  const ShownFrame& shown, FramePainter& painter) const {
  const HiddenArea& hidden = hidden_[eye];
  if (!hidden.is_empty()) {
    glEnable(GL_DEPTH_TEST);
    hidden.draw(fov);
  }
  painter.draw_film(shown, view);
  glDisable(GL_DEPTH_TEST);
}

void HeadsetConnection::draw(std::size_t eye, const XrFovf& fov, const ShownView& view,
                             ShownFrame& shown, FramePainter& painter, HeadsetMirror& mirror) {
  EyeImages& images = images_[eye];
  const bool is_asked_for_picture = eye == 0 && shown.picture != nullptr;
  images.begin();
  draw_film(eye, fov, view, shown, painter);
  if (is_asked_for_picture && shown.picture_is_bare) {
    shown.picture->set_value(read_picture(images.size_px()));
  }
  painter.draw_over(shown, images.size_px(), {&view, 1}, {});
  if (is_asked_for_picture && !shown.picture_is_bare) {
    shown.picture->set_value(read_picture(images.size_px()));
  }
  if (is_asked_for_picture) {
    shown.picture.reset();
  }
  if (eye == 0) {
    mirror.copy(view);
  }
  images.end();
}

}  // namespace foveola
