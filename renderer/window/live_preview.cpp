#include "renderer/window/live_preview.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "renderer/view/acuity.h"
#include "renderer/window/density_map.h"
#include "renderer/window/preview_panels.h"

namespace foveola {
namespace {

namespace fs = std::filesystem;

/// Where the published model of acuity begins to fall, and round numbers beyond.
constexpr std::array acuity_rings_deg = {reddy_knee_deg, 10.0, 20.0, 40.0};

constexpr int gaze_check_targets = 5;

fs::path picture_file(int number) { return fmt::format("foveola-{}.png", number); }

/// Keeps about the last `most` of a list that grows at its end.
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
      start_(parts.clock->now()),
      drawing_(parts.preview->film(), usual_drawer(parts.presenter->graphics()), *parts.workers) {
  show_in({.framebuffer = settings.framebuffer, .window = settings.framebuffer});
  restart();
}

LivePreviewReport LivePreview::run(const std::stop_token& stop) {
  // Events that came while waiting for the refresh are answered before the frame looks at the head.
  const auto wait_and_answer = [this](Nanoseconds time) {
    std::this_thread::sleep_until(std::chrono::steady_clock::time_point(time));
    answer_events();
  };
  LiveFrames live(*parts_.preview, *parts_.clock,
                  RefreshEstimator(settings_.display.refresh_rate_hz), wait_and_answer,
                  {.resample = [this](const Preview& preview) { draw(preview); },
                   .present = [this] { return wait_until_shown(); }},
                  frame_budget_for(usual_drawer(parts_.presenter->graphics())));
  while (!is_done_ && !stop.stop_requested()) {
    keep(live.next());
    tell_of_slow_drawing(live);
  }
  report_.is_refresh_measured = live.refresh().is_measured();
  report_.refresh_rate_hz = live.refresh().rate_hz();
  report_.framebuffer = area_.framebuffer;
  report_.graphics = parts_.presenter->graphics();
  if (last_picture_) {
    report_.last_picture = last_picture_->get();
  }
  pictures_.finish();
  return std::move(report_);
}

void LivePreview::answer_events() {
  for (const WindowEvent& event : parts_.events->take()) {
    parts_.steering->follow(event);
    answer(event);
  }
  // Methods that follow the pointer follow it as the view of the last frame has it.
  if (const std::optional<Vec3> pointer = parts_.steering->pointer()) {
    parts_.preview->point_at(glm::normalize(parts_.preview->viewport().head() * *pointer));
  }
}

void LivePreview::answer(const WindowEvent& event) {
  if (const auto* typed = std::get_if<CharacterTyped>(&event.what)) {
    if (const auto action = action_of(*typed)) {
      act(*action);
    }
  } else if (const auto* key = std::get_if<KeyMoved>(&event.what)) {
    if (const auto action = action_of(*key)) {
      act(*action);
    }
  } else if (const auto* size = std::get_if<WindowResized>(&event.what)) {
    show_in(*size);
  } else if (const auto* hidden = std::get_if<WindowHidden>(&event.what)) {
    area_.is_hidden = hidden->is_hidden;
  } else if (const auto* lost = std::get_if<MonitorLost>(&event.what)) {
    message_ = "lost the monitor " + lost->name;
    report_.lost_monitors.push_back(lost->name);
  } else if (const auto* found = std::get_if<MonitorFound>(&event.what)) {
    message_ = "found the monitor " + found->name;
  } else if (std::holds_alternative<CloseWanted>(event.what)) {
    is_done_ = true;
  }
}

void LivePreview::act(PreviewAction action) {
  if (follow(action, choices_)) {
    restart();
  }
  switch (action) {
    case PreviewAction::freeze_gaze:
      parts_.preview->hold_gaze(choices_.gaze_is_frozen);
      break;
    case PreviewAction::check_gaze:
      gaze_check_.emplace(calibration_targets(gaze_check_targets, geometry_.horizontal_fov_deg,
                                              geometry_.vertical_fov_deg),
                          settings_.gaze_check, parts_.clock->now());
      break;
    case PreviewAction::take_picture:
      wants_picture_ = true;
      break;
    case PreviewAction::toggle_full_screen:
      parts_.window->toggle_full_screen();
      break;
    case PreviewAction::close:
      is_done_ = true;
      break;
    default:
      break;
  }
}

void LivePreview::restart() {
  const std::string method = method_text(choices_);
  parts_.preview->restart(method, settings_.seed);
  report_.methods.push_back(method);
}

void LivePreview::show_in(const WindowResized& size) {
  area_.framebuffer = size.framebuffer;
  if (!area_.has_room()) {
    return;
  }
  geometry_ = view_geometry(settings_.display, size.framebuffer);
  parts_.preview->set_view({.horizontal_deg = geometry_.horizontal_fov_deg,
                            .vertical_deg = geometry_.vertical_fov_deg,
                            .lens = geometry_.lens});
  parts_.steering->show(geometry_, size.framebuffer,
                        static_cast<double>(size.framebuffer.x) / std::max(1, size.window.x));
}

void LivePreview::draw(const Preview& preview) {
  ShownFrame frame = head_frame(area_, geometry_, preview.viewport().head(), choices_.look);
  go_on_checking(preview);
  if (area_.is_seen()) {
    drawing_.bring_up_to_date(frame);
    frame.overlays = overlays(preview);
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
    const fs::path file = next_picture_file();
    message_ = "picture: " + file.string();
    pictures_.write(file, picture_of(frame));
  }
  wants_picture_ = false;
}

void LivePreview::go_on_checking(const Preview& preview) {
  if (!gaze_check_) {
    return;
  }
  gaze_check_->update(parts_.clock->now(), preview.arrived_gaze());
  if (!gaze_check_->target()) {
    end_check();
  }
}

void LivePreview::end_check() {
  GazeCheck check = check_gaze(gaze_check_->watched(), settings_.corrects_gaze, *parts_.eye);
  message_ = gaze_quality_line(check.quality);
  if (settings_.corrects_gaze) {
    message_ += check.correction ? ", now corrected" : ", too little to correct it by";
  }
  report_.gaze_checks.push_back(std::move(check));
  gaze_check_.reset();
}

std::optional<Nanoseconds> LivePreview::wait_until_shown() {
  const Nanoseconds shown = parts_.presenter->wait_until_shown();
  if (!report_.first_shown) {
    report_.first_shown = shown - start_;
  }
  // What is not drawn waits for no refresh.
  return area_.is_seen() ? std::optional(shown) : std::nullopt;
}

void LivePreview::keep(const LiveFrame& frame) {
  ++report_.frame_count;
  report_.late_frames += frame.is_late() ? 1 : 0;
  report_.frames.push_back(frame);
  forget_old(report_.frames, LivePreviewReport::most_frames);
  is_done_ = is_done_ || (settings_.frames && report_.frame_count >= *settings_.frames);
}

void LivePreview::tell_of_slow_drawing(const LiveFrames& live) {
  const std::optional<Nanoseconds> drawing = live.too_slow_drawing();
  if (!drawing || report_.slow_drawing) {
    return;
  }
  report_.slow_drawing = {.drawing = *drawing,
                          .interval = live.refresh().interval(),
                          .framebuffer = area_.framebuffer,
                          .graphics = parts_.presenter->graphics()};
  if (settings_.notify) {
    settings_.notify(slow_drawing_line(*report_.slow_drawing));
  }
}

fs::path LivePreview::next_picture_file() {
  // One that was taken a moment ago may not be on the disk yet.
  do {
    ++last_picture_number_;
  } while (fs::exists(picture_file(last_picture_number_)));
  return picture_file(last_picture_number_);
}

ViewOverlays LivePreview::overlays(const Preview& preview) const {
  constexpr int density_cells = 48;
  ViewOverlays overlays{.gaze = preview.gaze(), .shows_gaze = choices_.shows_gaze};
  if (gaze_check_) {
    overlays.target = preview.viewport().head() * *gaze_check_->target();
  }
  if (choices_.shows_rings) {
    for (const double ring_deg : acuity_rings_deg) {
      overlays.rings_rad.push_back(static_cast<float>(radians(ring_deg)));
    }
  }
  if (choices_.shows_density) {
    overlays.density =
        density_map(preview.sampler(), preview.viewport(), density_cells, density_cells);
  }
  return overlays;
}

std::vector<TextPanel> LivePreview::panels() const {
  std::vector<TextPanel> panels;
  if (choices_.shows_help) {
    panels.push_back({.place = PanelPlace::middle, .lines = help_lines()});
  }
  if (choices_.shows_frame_times) {
    panels.push_back({.place = PanelPlace::top_left,
                      .lines = frame_time_lines(report_.frames, method_text(choices_))});
  }
  if (choices_.shows_latency) {
    panels.push_back(
        {.place = PanelPlace::top_right,
         .lines = latency_lines(report_.frames, settings_.tracker, settings_.display)});
  }
  const std::string status = parts_.eye->status();
  if (!message_.empty() || !status.empty()) {
    TextPanel notes{.place = PanelPlace::bottom_left};
    for (const std::string& note : {message_, status}) {
      if (!note.empty()) {
        notes.lines.push_back(note);
      }
    }
    panels.push_back(std::move(notes));
  }
  return panels;
}

}  // namespace foveola
