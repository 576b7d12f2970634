#include "renderer/headset/gaze_times.h"

#include <utility>

namespace foveola {
namespace {

constexpr Nanoseconds longest_delay = std::chrono::seconds(1);

}  // namespace

std::optional<GazeSample> GazeTimes::sample_of(const ToldGaze& told) {
  const std::optional<ToldGaze> before = std::exchange(before_, told);
  const bool has_same_time = before && told.sampled && before->sampled == told.sampled;
  if (has_same_time && before->direction == told.direction && before->is_valid == told.is_valid) {
    return std::nullopt;
  }
  const bool goes_on =
      !before || !before->sampled || !told.sampled || *told.sampled > *before->sampled;
  const bool is_time_known = told.sampled && goes_on && *told.sampled <= told.asked &&
                             told.asked - *told.sampled <= longest_delay;
  return GazeSample{.time = is_time_known ? *told.sampled : told.asked,
                    .direction = told.is_valid ? told.direction : Vec3(0.0F, 0.0F, -1.0F),
                    .valid = told.is_valid,
                    .is_time_known = is_time_known};
}

}  // namespace foveola
