#include "study/stage/object_sight.h"

#include "renderer/base/angles.h"
#include "study/record/read/attempt_gaze_figures.h"

namespace foveola::study {
namespace {

constexpr Vec3 forward{0.0F, 0.0F, -1.0F};

double part(Nanoseconds some, const LookingTimes& times) {
  const Nanoseconds all = times.on_object + times.elsewhere + times.unknown;
  return all > Nanoseconds::zero() ? seconds(some) / seconds(all) : 0.0;
}

}  // namespace

ObjectSight object_sight(const Viewport& view, const OfferedObject& object) {
  return {.from_middle_deg = degrees(angle_between(view.head() * forward, object.direction)),
          .is_in_view = view.project(object.direction).has_value()};
}

void LookingTimes::add(const FrameRow& frame, Nanoseconds shown, const OfferedObject& object) {
  const SeenObject seen{.direction = object.direction, .radius_deg = object.radius_deg};
  Nanoseconds& time = !has_gaze(frame)               ? unknown
                      : is_gaze_on(seen, frame.gaze) ? on_object
                                                     : elsewhere;
  time += shown;
}

double LookingTimes::part_elsewhere() const { return part(elsewhere, *this); }

double LookingTimes::part_unknown() const { return part(unknown, *this); }

}  // namespace foveola::study
