// What the eyes of a headset see, as its runtime tells it, in the terms of the renderer.
#pragma once

#include <array>

#include <openxr/openxr.h>

#include "renderer/view/viewport.h"

namespace foveola {

inline Quat orientation_of(const XrPosef& pose) {
  const XrQuaternionf& q = pose.orientation;
  return {q.w, q.x, q.y, q.z};
}

/// One eye's, to each side of its axis as it likes: a display's half that is seen from beside its
/// middle, without a lens, since the runtime sees to that.
FieldOfView field_of_view_of(const XrFovf& fov);

/// What an eye sees of the sphere. world_from_room: the orientation of the space that `eye` is
/// located in.
Viewport viewport_of(const XrView& eye, const Quat& world_from_room);

/// How an eye sees a flat canvas that stands so many metres straight ahead of the head (its
/// orientation in the eyes' space), and on which a degree in the middle is as large as in the left
/// eye's picture: ShownView::part_from_canvas. Both eyes see it where it stands, wherever they are
/// and point.
Mat3 part_from_canvas(const std::array<XrView, 2>& eyes, std::size_t eye, const Quat& head,
                      float distance_m);

/// The field of view in the head's axes that holds both eyes', which may point outwards: at most
/// 80 degrees to each side. head: in the same space as the eyes.
FieldOfView field_of_view_of_both(const std::array<XrView, 2>& eyes, const Quat& head);

}  // namespace foveola
