#include <algorithm>

#include <glm/common.hpp>

#include "tests/openxr/runtime/script.h"

namespace foveola::test::openxr {
namespace {

/// The keys around a time, and how far it is from the one to the other, 0 to 1.
template <typename Key>
struct Between {
  const Key& before;
  const Key& after;
  double share;
};

/// keys: at least one.
template <typename Key>
Between<Key> between(const std::vector<Key>& keys, double time_s) {
  const auto after =
      std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.time_s > time_s; });
  if (after == keys.begin()) {
    return {keys.front(), keys.front(), 0.0};
  }
  if (after == keys.end()) {
    return {keys.back(), keys.back(), 0.0};
  }
  const Key& before = *std::prev(after);
  return {before, *after, (time_s - before.time_s) / (after->time_s - before.time_s)};
}

}  // namespace

Pose head_at(const Script& script, double time_s) {
  if (script.head.empty()) {
    return {};
  }
  const auto [a, b, share] = between(script.head, time_s);
  return turned({glm::mix(a.turn.yaw_deg, b.turn.yaw_deg, share),
                 glm::mix(a.turn.pitch_deg, b.turn.pitch_deg, share),
                 glm::mix(a.turn.roll_deg, b.turn.roll_deg, share)},
                glm::mix(a.position_m, b.position_m, share));
}

bool is_head_tracked(const Script& script, double time_s) {
  return !is_in_any(script.head_gaps, time_s);
}

Pose gaze_at(const Script& script, double time_s) {
  if (script.gaze.empty()) {
    return {};
  }
  for (const GazeGapInterval& gap : script.gaze_gaps) {
    if (gap.when.holds(time_s)) {
      time_s = gap.when.from_s;
    }
  }
  const auto [a, b, share] = between(script.gaze, time_s);
  return turned(
      {glm::mix(a.yaw_deg, b.yaw_deg, share), glm::mix(a.pitch_deg, b.pitch_deg, share), 0.0});
}

std::optional<GazeGap> gaze_gap_at(const Script& script, double time_s) {
  for (const GazeGapInterval& gap : script.gaze_gaps) {
    if (gap.when.holds(time_s)) {
      return gap.kind;
    }
  }
  return std::nullopt;
}

SampleTimeStep sample_time_at(const Script& script, double time_s) {
  SampleTimeStep latest;
  for (const SampleTimeStep& step : script.gaze_sample_times) {
    if (step.time_s <= std::max(time_s, 0.0)) {
      latest = step;
    }
  }
  return latest;
}

const InputStep* input_at(const Script& script, const std::string& path, double time_s) {
  const InputStep* latest = nullptr;
  for (const InputStep& step : script.inputs) {
    if (step.time_s <= time_s && step.path == path) {
      latest = &step;
    }
  }
  return latest;
}

bool is_in_any(const std::vector<Interval>& intervals, double time_s) {
  return std::any_of(intervals.begin(), intervals.end(),
                     [&](const Interval& interval) { return interval.holds(time_s); });
}

}  // namespace foveola::test::openxr
