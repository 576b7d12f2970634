// The views of a headset's eyes, their parts hidden by the lenses, and the swapchains of their
// pictures.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <openxr/openxr.h>

#include "renderer/headset/xr_instance.h"
#include "renderer/view/viewport.h"
#include "renderer/window/drawing/gl_objects.h"

namespace foveola {

/// One eye's swapchain. Needs the session's context throughout.
class EyeImages {
 public:
  /// Of the runtime's recommended size for this eye, 0 or 1. instance must outlive it; the session
  /// is destroyed after it. Throws Error if the runtime has no pictures of 8 bits in sRGB.
  EyeImages(const XrInstanceOwner& instance, XrSession session, std::size_t eye);

  /// Waits for the next picture and binds a framebuffer for it, cleared to black and maximum depth.
  void begin();
  /// Hands the picture to the runtime.
  void end();

  const IVec2& size_px() const { return size_px_; }
  /// The visible part of the last picture handed over: all of it.
  XrSwapchainSubImage sub_image() const;

 private:
  XrSwapchain make_swapchain(XrSession session) const;
  void make_framebuffers();

  const XrInstanceOwner* instance_;
  IVec2 size_px_;
  XrSwapchain swapchain_ = XR_NULL_HANDLE;
  GlRenderbuffer depths_;
  std::vector<GlFramebuffer> framebuffers_;  ///< one per picture
};

inline Quat orientation_of(const XrPosef& pose) {
  const XrQuaternionf& q = pose.orientation;
  return {q.w, q.x, q.y, q.z};
}

/// One eye's field of view, asymmetric about its axis: that of an off-centre half of a display,
/// without a lens, since the runtime corrects for the lens.
FieldOfView field_of_view_of(const XrFovf& fov);

/// An eye's view of the sphere. world_from_room: the orientation of the space of `eye`.
Viewport viewport_of(const XrView& eye, const Quat& world_from_room);

/// Maps a flat canvas to an eye's picture: ShownView::part_from_canvas. The canvas is distance_m
/// straight ahead of the head (its orientation in the eyes' space), and a degree in its centre is
/// as large as in the left eye's picture. Both eyes see it at its place, wherever they are and
/// point.
Mat3 part_from_canvas(const std::array<XrView, 2>& eyes, std::size_t eye, const Quat& head,
                      float distance_m);

/// The field of view in the head's axes that contains both eyes' views, which may point outwards:
/// at most 80 degrees to each side. head: in the same space as the eyes.
FieldOfView field_of_view_of_both(const std::array<XrView, 2>& eyes, const Quat& head);

/// The parts hidden by a lens: the corners of triangles, three each, on the plane at distance 1
/// before its eye, x to the right and y up.
using HiddenTriangles = std::vector<Vec2>;

/// The cells, of 64 by 64, that an eye sees at least partly. Null if that is all of them, or none.
/// both: field_of_view_of_both. head: in the same space as the eyes.
std::shared_ptr<const SeenPart> seen_by_eyes(const std::array<XrView, 2>& eyes, const Quat& head,
                                             const FieldOfView& both,
                                             const std::array<HiddenTriangles, 2>& hidden);

/// Needs the session's context throughout.
class HiddenArea {
 public:
  /// Of eye 0 or 1, as currently reported by the runtime; empty if it reports none.
  HiddenArea(const XrInstanceOwner& instance, XrSession session, std::size_t eye);

  bool is_empty() const { return triangles_.empty(); }
  const HiddenTriangles& triangles() const { return triangles_; }
  /// Fills it in black at minimum depth, in a picture with this view. Anything drawn behind it with
  /// a depth test then costs nothing.
  void draw(const XrFovf& fov) const;

 private:
  GlProgram program_;
  GlVertexArray vertices_;
  GlBuffer corners_;
  HiddenTriangles triangles_;
};

}  // namespace foveola
