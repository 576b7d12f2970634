#include "study/stage/object_sight.h"

#include "renderer/base/angles.h"

namespace foveola::study {
namespace {

constexpr Vec3 forward{0.0F, 0.0F, -1.0F};

double part(Nanoseconds some, const GazeTimes& times) {
  const Nanoseconds all = times.on_object + times.elsewhere + times.unknown;
  return all > Nanoseconds::zero() ? seconds(some) / seconds(all) : 0.0;
}

}  // namespace

ObjectSight object_sight(const Viewport& view, const OfferedObject& object) {
  return {.from_middle_deg = degrees(angle_between(view.head() * forward, object.direction)),
          .is_in_view = view.project(object.direction).has_value()};
}

bool is_gaze_on(const OfferedObject& object, const Vec3& gaze) {
  return degrees(angle_between(gaze, object.direction)) <= object.radius_deg + gaze_margin_deg;
}

double GazeTimes::part_elsewhere() const { return part(elsewhere, *this); }

double GazeTimes::part_unknown() const { return part(unknown, *this); }

}  // namespace foveola::study
