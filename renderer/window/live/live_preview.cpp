#include "renderer/window/live/live_preview.h"

#include <algorithm>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace foveola {
namespace {

/// Keeps about the last `most` items of a list that grows at its end.
template <typename Item>
void forget_old(std::vector<Item>& list, std::size_t most) {
  if (list.size() >= 2 * most) {
    list.erase(list.begin(), list.end() - static_cast<std::ptrdiff_t>(most));
  }
}

}  // namespace

LivePreview::LivePreview(const LivePreviewSettings& settings, const Parts& parts)
    : settings_(settings),
      parts_(parts),
      choices_(settings.choices),
      area_{.framebuffer = settings.framebuffer},
      window_{.framebuffer = settings.window_px, .window = settings.window_px},
      view_(settings.display, settings.larger_fov_deg, settings.framebuffer),
      start_(parts.clock->now()),
      drawing_(parts.preview->film(), parts.presenter->film_drawer(), *parts.workers) {
  show_view();
  restart();
  report_warnings();
}

LivePreviewReport LivePreview::run(const std::stop_token& stop) {
  // Events during the wait for the refresh are handled before the frame polls the head.
  const auto wait_and_answer = [this](Nanoseconds time) {
    std::this_thread::sleep_until(std::chrono::steady_clock::time_point(time));
    answer_events();
  };
  LiveFrames live(*parts_.preview, *parts_.clock,
                  RefreshEstimator(settings_.display.refresh_rate_hz), wait_and_answer,
                  {.resample = [this](const Preview& preview) { draw(preview); },
                   .present = [this] { return wait_until_shown(); }},
                  frame_budget_for(parts_.presenter->film_drawer()));
  while (!is_done_ && !stop.stop_requested()) {
    live.give_way(settings_.is_loading && settings_.is_loading());
    keep(live.next());
    report_slow_drawing(live);
  }
  report_.is_refresh_measured = live.refresh().is_measured();
  report_.refresh_rate_hz = live.refresh().rate_hz();
  report_.framebuffer = area_.framebuffer;
  report_.last_view = view_options(shown_now());
  report_.graphics = parts_.presenter->graphics();
  if (last_picture_) {
    report_.last_picture = last_picture_->get();
  }
  pictures_.finish();
  return std::move(report_);
}

void LivePreview::report_pictures() {
  for (const DisplayPictures::Written& picture : pictures_.take_written()) {
    if (picture.fault.empty()) {
      tell("saved " + picture.file.string());
    } else {
      tell("not saved: " + picture.fault, MessageStay::long_enough);
      print("foveola: warning: a picture was not saved: " + picture.fault);
    }
  }
}

void LivePreview::report_warnings() {
  if (settings_.has_studio_light) {
    tell("nothing in the scene emits light: a studio light", MessageStay::long_enough);
  }
  if (const std::size_t count = settings_.warnings.size(); count > 0) {
    tell(fmt::format("{} warning{} of the scene: w shows {}", count, count == 1 ? "" : "s",
                     count == 1 ? "it" : "them"),
         MessageStay::long_enough);
  }
}

/// The film of another place is invalid.
void LivePreview::move_camera() {
  parts_.camera->walk_until(parts_.clock->now());
  if (parts_.camera->position() != parts_.preview->settings().render.viewpoint) {
    parts_.preview->stand_at(parts_.camera->position());
  }
  if (const std::string note = parts_.camera->take_note(); !note.empty()) {
    tell(note);
  }
}

/// View, method, gaze and exposure are kept.
void LivePreview::follow_change() {
  std::optional<SceneChange> change =
      settings_.take_change ? settings_.take_change() : std::nullopt;
  if (!change) {
    return;
  }
  for (const std::string& remark : change->remarks) {
    print(remark);
  }
  if (change->tracer != nullptr) {
    parts_.camera->move_into(std::move(change->surroundings));
    parts_.preview->show(*change->tracer, parts_.camera->position());
    scene_ = std::move(change->owner);
    tell("the scene has changed");
    settings_.warnings = std::move(change->warnings);
    settings_.has_studio_light = change->has_studio_light;
    report_warnings();
  } else {
    tell("the scene has changed but does not load, see the terminal: the old one stays",
         MessageStay::long_enough);
  }
  not_shown_ = std::move(change);
}

void LivePreview::note_change_shown(const LiveFrame& frame) {
  if (not_shown_) {
    report_.changes.push_back(
        {.is_refused = not_shown_->tracer == nullptr, .after = frame.shown - not_shown_->changed});
    not_shown_.reset();
  }
}

void LivePreview::restart() {
  const std::string method = method_text(choices_);
  parts_.preview->cut_samples(largest_radiance(choices_));
  parts_.preview->restart(method, settings_.seed);
  report_.methods.push_back(method);
}

void LivePreview::show_view() {
  const ViewGeometry& geometry = view_.geometry();
  parts_.preview->set_view(geometry.field_of_view());
  const ViewGeometry in_window = parts_.presenter->in_window(geometry, window_.framebuffer);
  const double pixels_per_unit =
      static_cast<double>(window_.framebuffer.x) / std::max(1, window_.window.x);
  parts_.steering->show(in_window, window_.framebuffer, pixels_per_unit);
  parts_.camera->show(in_window, window_.framebuffer, pixels_per_unit);
  if (parts_.widened_eye != nullptr) {
    parts_.widened_eye->widen(view_.times_true());
  }
}

void LivePreview::tell(const std::string& message, MessageStay stay) {
  messages_.tell(parts_.clock->now(), message, stay);
}

void LivePreview::print(const std::string& line) const {
  if (settings_.notify) {
    settings_.notify(line);
  }
}

void LivePreview::draw(const Preview& preview) {
  continue_check(preview);
  ViewLook look = choices_.look;
  // A moving view has few samples: isolated dots would show little.
  look.fill_unsampled = look.fill_unsampled || parts_.camera->is_moving();
  ShownFrame frame = head_frame(area_, view_.geometry(), preview.viewport().head(), look);
  frame.late_turn_rad = parts_.presenter->late_turn_rad();
  if (area_.is_seen()) {
    drawing_.bring_up_to_date(frame);
    frame.overlays = check_.is_running() ? check_.overlays(preview.viewport().head())
                                         : preview_overlays(choices_, preview);
    frame.panels = panels();
    take_picture(frame);
  }
  parts_.presenter->draw(std::move(frame));
}

void LivePreview::take_picture(ShownFrame& frame) {
  const bool is_last = settings_.frames && report_.frame_count + 1 == *settings_.frames;
  if (is_last && settings_.keeps_last_picture) {
    last_picture_ = picture_of(frame);
  } else if (wants_picture_) {
    frame.picture_is_bare = true;
    pictures_.write_next(picture_of(frame));
  }
  wants_picture_ = false;
}

/// At true angles, in which a tracker is judged.
void LivePreview::begin_check() {
  view_.measure_eyes(true);
  show_view();
  check_.begin(view_.geometry(), settings_.gaze_check, parts_.clock->now());
}

void LivePreview::continue_check(const Preview& preview) {
  if (const auto watched = check_.update(parts_.clock->now(), preview.arrived_gaze())) {
    end_check();
    judge(*watched);
  }
}

void LivePreview::end_check() {
  check_.end();
  view_.measure_eyes(false);
  show_view();
}

void LivePreview::judge(const std::vector<WatchedTarget>& watched) {
  GazeCheck check = check_gaze(watched, settings_.corrects_gaze, *parts_.eye);
  std::string result = gaze_quality_line(check.quality);
  if (settings_.corrects_gaze) {
    result += check.correction ? ", now corrected" : ", too little to correct it by";
  }
  tell(result, MessageStay::until_key);
  report_.gaze_checks.push_back(std::move(check));
}

std::optional<Nanoseconds> LivePreview::wait_until_shown() {
  const Nanoseconds shown = parts_.presenter->wait_until_shown();
  if (!report_.first_shown) {
    report_.first_shown = shown - start_;
  }
  // A hidden window does not wait for refreshes.
  return area_.is_seen() ? std::optional(shown) : std::nullopt;
}

void LivePreview::keep(const LiveFrame& frame) {
  note_change_shown(frame);
  ++report_.frame_count;
  report_.late_frames += frame.is_late() ? 1 : 0;
  report_.frames.push_back(frame);
  forget_old(report_.frames, LivePreviewReport::max_frames);
  is_done_ = is_done_ || (settings_.frames && report_.frame_count >= *settings_.frames);
}

void LivePreview::report_slow_drawing(const LiveFrames& live) {
  const std::optional<Nanoseconds> drawing = live.too_slow_drawing();
  if (!drawing || report_.slow_drawing) {
    return;
  }
  report_.slow_drawing = {.drawing = *drawing,
                          .interval = live.refresh().interval(),
                          .framebuffer = area_.framebuffer,
                          .graphics = parts_.presenter->graphics()};
  print(slow_drawing_line(*report_.slow_drawing));
  tell(slow_drawing_note(*report_.slow_drawing), MessageStay::long_enough);
}

std::vector<TextPanel> LivePreview::panels() const {
  if (check_.is_running()) {
    return {check_.panel()};
  }
  std::vector<std::string> notes = messages_.lines(parts_.clock->now());
  if (const std::string status = parts_.eye->status(); !status.empty()) {
    notes.push_back(status);
  }
  return preview_panels(choices_, {.notes = std::move(notes),
                                   .warnings = settings_.warnings,
                                   .frames = report_.frames,
                                   .tracker = settings_.tracker,
                                   .display = settings_.display,
                                   .shown = shown_now()});
}

ShownNow LivePreview::shown_now() const {
  const Quat& head = parts_.preview->viewport().head();
  ShownNow shown{.view = view_.in_words(),
                 .camera = parts_.camera->place(),
                 .head = azimuth_elevation(head * Vec3(0.0F, 0.0F, -1.0F)),
                 .speed_m_per_s = parts_.camera->speed_m_per_s(),
                 .exposure_stops = choices_.look.exposure_stops,
                 .curve = choices_.look.curve,
                 .largest_radiance = largest_radiance(choices_)};
  if (view_.is_free()) {
    shown.horizontal_fov_deg = view_.geometry().horizontal_fov_deg;
  }
  return shown;
}

}  // namespace foveola
