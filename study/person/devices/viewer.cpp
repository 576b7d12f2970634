#include "study/person/devices/viewer.h"

#include "renderer/base/angles.h"

namespace foveola::study {
namespace {

bool turns_head(const WindowEvent& event) {
  const auto* key = std::get_if<KeyMoved>(&event.what);
  return key != nullptr && key->is_down;
}

}  // namespace

void Viewer::look_along(const AzimuthElevation& heading) {
  if (worn_ != nullptr) {
    worn_->face(heading);
  }
  neck_.emplace(heading, pointer_);
  neck_->steering.show(sight_.geometry, sight_.framebuffer, sight_.pixels_per_unit);
}

void Viewer::show(const ViewGeometry& geometry, const IVec2& framebuffer, double pixels_per_unit) {
  sight_ = {.geometry = geometry, .framebuffer = framebuffer, .pixels_per_unit = pixels_per_unit};
  neck_->steering.show(geometry, framebuffer, pixels_per_unit);
}

void Viewer::follow(const WindowEvent& event, bool sees_picture) {
  if (sees_picture || !turns_head(event)) {
    neck_->steering.follow(event);
  }
}

void Viewer::turn_to(const Vec3& direction, Nanoseconds time) {
  const AzimuthElevation there = azimuth_elevation(direction);
  const AzimuthElevation here = neck_->head.pose(time).heading;
  neck_->head.turn(time, {.right_rad = wrapped_angle(there.azimuth_rad - here.azimuth_rad),
                          .up_rad = there.elevation_rad - here.elevation_rad});
}

}  // namespace foveola::study
