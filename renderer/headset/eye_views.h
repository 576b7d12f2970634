// What the eyes of a headset see, the part of their pictures that the lenses hide, and the
// swapchains that the pictures are drawn into.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <openxr/openxr.h>

#include "renderer/headset/xr_instance.h"
#include "renderer/view/viewport.h"
#include "renderer/window/drawing/gl_objects.h"

namespace foveola {

/// One eye's. Needs the session's context in all that it does.
class EyeImages {
 public:
  /// Of the size that the runtime recommends for this eye, 0 or 1. instance must outlive it; the
  /// session is destroyed after it. Throws Error if the runtime has no pictures of 8 bits in sRGB.
  EyeImages(const XrInstanceOwner& instance, XrSession session, std::size_t eye);

  /// Waits for the next picture and binds a framebuffer for it, in black and far away.
  void begin();
  /// Hands it to the runtime.
  void end();

  const IVec2& size_px() const { return size_px_; }
  /// The part that is seen of what was handed over last: all of it.
  XrSwapchainSubImage sub_image() const;

 private:
  XrSwapchain make_swapchain(XrSession session) const;
  void make_framebuffers();

  const XrInstanceOwner* instance_;
  IVec2 size_px_;
  XrSwapchain swapchain_ = XR_NULL_HANDLE;
  GlRenderbuffer depths_;
  std::vector<GlFramebuffer> framebuffers_;  ///< one for each picture
};

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

/// What a lens never shows: the corners of triangles, three for each, on the plane at distance 1
/// before its eye, x to the right and y up.
using HiddenTriangles = std::vector<Vec2>;

/// Of 64 by 64 cells those in which, or at whose edges, an eye sees anything. Null if that is all
/// of them, or none. both: field_of_view_of_both. head: in the same space as the eyes.
std::shared_ptr<const SeenPart> seen_by_eyes(const std::array<XrView, 2>& eyes, const Quat& head,
                                             const FieldOfView& both,
                                             const std::array<HiddenTriangles, 2>& hidden);

/// Needs the session's context in all that it does.
class HiddenArea {
 public:
  /// Of eye 0 or 1, as the runtime tells it now; empty where it does not.
  HiddenArea(const XrInstanceOwner& instance, XrSession session, std::size_t eye);

  bool is_empty() const { return triangles_.empty(); }
  const HiddenTriangles& triangles() const { return triangles_; }
  /// Fills it in black in a picture with so wide a view, as near as can be: what is drawn behind
  /// it, while depths are tested, costs nothing.
  void draw(const XrFovf& fov) const;

 private:
  GlProgram program_;
  GlVertexArray vertices_;
  GlBuffer corners_;
  HiddenTriangles triangles_;
};

}  // namespace foveola
