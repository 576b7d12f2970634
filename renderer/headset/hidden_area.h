// The part of an eye's picture that its lens never shows: nothing is resampled there.
#pragma once

#include "renderer/headset/seen_by_eyes.h"
#include "renderer/headset/xr_instance.h"
#include "renderer/window/gl_objects.h"

namespace foveola {

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
