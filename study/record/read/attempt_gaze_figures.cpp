#include "study/record/read/attempt_gaze_figures.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "renderer/gaze/eye_movements.h"
#include "renderer/gaze/gaze_filter.h"

namespace foveola::study {
namespace {

double degrees_between(const Vec3& a, const Vec3& b) { return degrees(angle_between(a, b)); }

Quat head_of(const FrameRow& frame) {
  return head_orientation(
      {.azimuth_rad = frame.head_azimuth_rad, .elevation_rad = frame.head_elevation_rad},
      frame.head_roll_rad);
}

/// The head as it was polled last before `time`, or first of all.
Quat head_at(const std::vector<FrameRow>& frames, Nanoseconds time) {
  const auto later =
      std::upper_bound(frames.begin(), frames.end(), time,
                       [](Nanoseconds sought, const FrameRow& row) { return sought < row.time; });
  return head_of(later == frames.begin() ? frames.front() : *std::prev(later));
}

/// The sum, or the time that is nearest to it: those of a file may be any.
Nanoseconds sum_of(Nanoseconds a, Nanoseconds b) {
  std::int64_t sum = 0;
  if (__builtin_add_overflow(a.count(), b.count(), &sum)) {
    return a < Nanoseconds(0) ? Nanoseconds::min() : Nanoseconds::max();
  }
  return Nanoseconds(sum);
}

GazeTimes gaze_times(const WatchedAttempt& attempt, Nanoseconds end) {
  Nanoseconds all{0};
  Nanoseconds without_gaze{0};
  Nanoseconds on_object{0};
  Nanoseconds elsewhere{0};
  const std::vector<FrameRow>& frames = attempt.frames;
  for (std::size_t i = 0; i < frames.size() && frames[i].presented < end; ++i) {
    const Nanoseconds next = i + 1 < frames.size() ? frames[i + 1].presented : end;
    const Nanoseconds shown = std::min(next, end) - frames[i].presented;
    all = sum_of(all, shown);
    if (!has_gaze(frames[i])) {
      without_gaze = sum_of(without_gaze, shown);
    } else if (attempt.object) {
      Nanoseconds& part = is_gaze_on(*attempt.object, frames[i].gaze) ? on_object : elsewhere;
      part = sum_of(part, shown);
    }
  }
  GazeTimes times{.all_s = seconds(all), .without_gaze_s = seconds(without_gaze)};
  if (attempt.object) {
    times.on_object_s = seconds(on_object);
    times.elsewhere_s = seconds(elsewhere);
  }
  return times;
}

/// The mean of the valid samples' directions in the world, not of unit length; zero, which is on no
/// object, without any.
Vec3 mean_direction(const MarkedMovement& movement, const std::vector<FrameRow>& frames) {
  Vec3 sum(0.0F);
  for (const GazeSample& sample : movement.samples) {
    if (sample.valid) {
      sum += head_at(frames, sample.time) * sample.direction;
    }
  }
  return sum;
}

bool is_marked(const GazeSample& sample) { return sample.mark != GazeMark::none; }

std::optional<FixationFigures> fixation_figures(const WatchedAttempt& attempt, Nanoseconds end) {
  std::vector<GazeSample> samples;
  std::copy_if(attempt.samples.begin(), attempt.samples.end(), std::back_inserter(samples),
               [&](const GazeSample& sample) {
                 return sample.time >= attempt.frames.front().presented && sample.time <= end;
               });
  if (std::none_of(samples.begin(), samples.end(), is_marked)) {
    return std::nullopt;
  }
  FixationFigures figures;
  double lasting_s = 0.0;
  std::size_t on_object = 0;
  for (const MarkedMovement& movement : marked_movements(samples)) {
    if (movement.mark != GazeMark::fixation) {
      continue;
    }
    ++figures.count;
    lasting_s += seconds(movement.duration);
    on_object +=
        attempt.object && is_gaze_on(*attempt.object, mean_direction(movement, attempt.frames)) ? 1
                                                                                                : 0;
  }
  if (figures.count > 0) {
    figures.mean_duration_s = lasting_s / static_cast<double>(figures.count);
  }
  if (attempt.object) {
    figures.on_object = on_object;
  }
  return figures;
}

GazeAtMark gaze_at(const MarkedMoment& mark, const WatchedAttempt& attempt) {
  GazeAtMark figures{.mark = mark.mark};
  const FrameRow* const frame = frame_on_display(attempt.frames, mark.time);
  if (frame == nullptr || !attempt.object) {
    return figures;
  }
  const Vec3& direction = attempt.object->direction;
  if (has_gaze(*frame)) {
    figures.gaze_from_object_deg = degrees_between(frame->gaze, direction);
  }
  const Quat head = head_of(*frame);
  figures.object_from_middle_deg = degrees_between(head * Vec3(0.0F, 0.0F, -1.0F), direction);
  if (attempt.view) {
    figures.object_in_view = viewport_of(head, *attempt.view).project(direction).has_value();
  }
  return figures;
}

}  // namespace

bool is_gaze_on(const SeenObject& object, const Vec3& gaze) {
  return gaze != Vec3(0.0F) &&
         degrees_between(gaze, object.direction) <= object.radius_deg + gaze_margin_deg;
}

bool has_gaze(const FrameRow& frame) {
  return frame.gaze_valid && !frame.gaze_held && frame.gaze_age <= longest_hold;
}

const FrameRow* frame_on_display(const std::vector<FrameRow>& frames, Nanoseconds time) {
  const auto later = std::upper_bound(
      frames.begin(), frames.end(), time,
      [](Nanoseconds sought, const FrameRow& row) { return sought < row.presented; });
  return later == frames.begin() ? nullptr : &*std::prev(later);
}

AttemptGazeFigures attempt_gaze_figures(const WatchedAttempt& attempt) {
  AttemptGazeFigures figures;
  for (const MarkedMoment& mark : attempt.marks) {
    if (!mark.censored) {
      figures.marks.push_back(gaze_at(mark, attempt));
    }
  }
  const bool is_known = !attempt.marks.empty() && !attempt.frames.empty() &&
                        attempt.frames.front().presented < attempt.marks.back().time;
  if (is_known) {
    const Nanoseconds end = attempt.marks.back().time;
    figures.times = gaze_times(attempt, end);
    figures.fixations = fixation_figures(attempt, end);
  }
  return figures;
}

}  // namespace foveola::study
