#include "renderer/gaze/gaze_marker.h"

#include <algorithm>

#include "renderer/gaze/gaze_filter.h"

namespace foveola {
namespace {

GazeMark mark_of(const EyeMovement& movement) {
  switch (movement.kind) {
    case EyeMovementKind::fixation:
      return GazeMark::fixation;
    case EyeMovementKind::saccade:
      return GazeMark::saccade;
    case EyeMovementKind::no_data:
      break;
  }
  return movement.end - movement.start <= longest_hold ? GazeMark::blink : GazeMark::none;
}

/// A valid sample ends a time without data, and belongs to the movement that comes then.
bool leads_to(const EyeMovement& movement, const GazeSample& sample) {
  const bool ends_no_data = movement.kind == EyeMovementKind::no_data && sample.valid;
  return ends_no_data ? sample.time < movement.end : sample.time <= movement.end;
}

}  // namespace

void GazeMarker::push(const GazeSample& sample, std::vector<GazeSample>& marked) {
  waiting_.push_back(sample);
  for (const EyeMovement& movement : detector_.push(sample)) {
    take(movement, marked);
  }
}

void GazeMarker::finish(std::vector<GazeSample>& marked) {
  if (const std::optional<EyeMovement> last = detector_.finish()) {
    take(*last, marked);
  }
  marked.insert(marked.end(), waiting_.begin(), waiting_.end());
  waiting_.clear();
}

void GazeMarker::take(const EyeMovement& movement, std::vector<GazeSample>& marked) {
  auto sample = waiting_.begin();
  for (; sample != waiting_.end() && leads_to(movement, *sample); ++sample) {
    sample->mark = mark_of(movement);
    marked.push_back(*sample);
  }
  waiting_.erase(waiting_.begin(), sample);
}

std::vector<MarkedMovement> marked_movements(std::span<const GazeSample> samples) {
  std::vector<MarkedMovement> movements;
  for (auto begin = samples.begin(); begin != samples.end();) {
    const auto end = std::find_if(
        begin, samples.end(), [&](const GazeSample& sample) { return sample.mark != begin->mark; });
    const Nanoseconds until = end == samples.end() ? samples.back().time : end->time;
    movements.push_back({begin->mark, {begin, end}, std::max(until - begin->time, Nanoseconds(0))});
    begin = end;
  }
  return movements;
}

}  // namespace foveola
