#include "renderer/headset/headset_presenter.h"

#include "renderer/base/error.h"

namespace foveola {
namespace {

/// A connected and running headset is ready long before.
constexpr Nanoseconds longest_start = std::chrono::seconds(20);
/// Between attempts to find a lost headset.
constexpr Nanoseconds search_interval = std::chrono::seconds(1);
constexpr Nanoseconds frame_of_nobody = std::chrono::milliseconds(11);

void sleep_for(Nanoseconds duration) { std::this_thread::sleep_for(duration); }

}  // namespace

HeadsetPresenter::HeadsetPresenter(Window& window, WindowEvents& events, const Clock& clock)
    : window_(&window), events_(&events), clock_(&clock), mirror_(window) {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  handover_.wait_until_ready();
}

HeadsetPresenter::~HeadsetPresenter() = default;

ViewGeometry HeadsetPresenter::in_window(const ViewGeometry& /*shown*/,
                                         const IVec2& window_px) const {
  const FieldOfView& left = facts_->eyes.front();
  return {.horizontal_fov_deg = left.horizontal_deg,
          .vertical_fov_deg = left.vertical_deg,
          .lens = left.lens,
          .turned = facts_->head_from_eyes.front(),
          .parts = {largest_part(window_px, facts_->eye_px.front())}};
}

void HeadsetPresenter::run(const std::stop_token& stop) {
  try {
    window_->make_current(0);
    FramePainter painter;
    graphics_ = graphics_name();
    serve(painter, stop);
  } catch (...) {
    handover_.fail(std::current_exception());
  }
  give_up_picture();
  window_->release();
}

void HeadsetPresenter::serve(FramePainter& painter, const std::stop_token& stop) {
  bool is_lost = false;
  const auto lose = [&] {
    if (!std::exchange(is_lost, true)) {
      tell(HeadsetChange::lost);
    }
  };
  while (!stop.stop_requested()) {
    try {
      HeadsetConnection headset;
      if (std::exchange(is_lost, false)) {
        tell(HeadsetChange::found);
      }
      show_in(headset, painter, stop);
      if (headset.session().is_over()) {
        tell(HeadsetChange::exit_wanted);
        break;
      }
    } catch (const HeadsetLost&) {
      if (!facts_) {
        throw Error("headset", "its runtime went away as it was to begin",
                    "restart the headset's runtime");
      }
      lose();
    } catch (const Error&) {
      // A missing headset at the start is an error; one lost later is sought until it is back.
      if (!facts_) {
        throw;
      }
      lose();
    }
    serve_nobody(painter, search_interval, stop);
  }
  while (!stop.stop_requested()) {
    serve_nobody(painter, search_interval, stop);
  }
}

void HeadsetPresenter::show_in(HeadsetConnection& headset, FramePainter& painter,
                               const std::stop_token& stop) {
  const Nanoseconds start = clock_->now();
  while (!stop.stop_requested() && !headset.session().is_over()) {
    headset.follow_events(changes_);
    for (const HeadsetChange change : std::exchange(changes_, {})) {
      tell(change);
    }
    if (headset.session().is_running()) {
      show_frame(headset, painter);
    } else {
      serve_nobody(painter, frame_of_nobody, stop);
    }
    if (!facts_ && clock_->now() - start > longest_start) {
      throw Error("headset", "its runtime does not show the program, or does not know the head",
                  "put it on, and end what else is shown in it");
    }
  }
}

void HeadsetPresenter::show_frame(HeadsetConnection& headset, FramePainter& painter) {
  const XrPlannedFrame planned = headset.session().wait_for_frame();
  const Nanoseconds now = clock_->now();
  const bool is_new = take_frame(painter);
  headset.ask(now, planned, motion_, keys_);
  for (WindowEvent& key : std::exchange(keys_, {})) {
    events_->push(std::move(key));
  }
  if (is_new) {
    handover_.note_shown(now);
  }
  mirror_.begin_frame(now);
  headset.show(planned, shown_, motion_.world_from_room(), painter, mirror_);
  mirror_.show(motion_.newest_gaze(), shown_.panels, painter);
  learn_facts(headset, planned, now);
}

void HeadsetPresenter::learn_facts(HeadsetConnection& headset, const XrPlannedFrame& planned,
                                   Nanoseconds asked) {
  if (!facts_) {
    facts_ = headset.facts(planned, asked);
    if (facts_) {
      handover_.be_ready();
    }
  }
}

bool HeadsetPresenter::take_frame(FramePainter& painter) {
  std::optional<ShownFrame> frame = handover_.take_frame();
  if (!frame) {
    return false;
  }
  give_up_picture();
  shown_ = *std::move(frame);
  painter.update_film(shown_);
  shown_.atlas = nullptr;
  shown_.update.clear();
  handover_.note_drawn();
  return true;
}

void HeadsetPresenter::give_up_picture() {
  if (shown_.picture) {
    shown_.picture->set_exception(std::make_exception_ptr(
        Error("headset", "it did not show the frame of the picture", "wear it")));
    shown_.picture.reset();
  }
}

void HeadsetPresenter::serve_nobody(FramePainter& painter, Nanoseconds duration,
                                    const std::stop_token& stop) {
  const Nanoseconds end = clock_->now() + duration;
  do {
    sleep_for(frame_of_nobody);
    if (take_frame(painter)) {
      handover_.note_shown(clock_->now());
    }
  } while (!stop.stop_requested() && clock_->now() < end);
}

void HeadsetPresenter::tell(HeadsetChange change) {
  if (change == HeadsetChange::recentred || change == HeadsetChange::lost) {
    motion_.forget_past();
  }
  events_->push({.time = clock_->now(), .what = HeadsetChanged{change}});
}

}  // namespace foveola
