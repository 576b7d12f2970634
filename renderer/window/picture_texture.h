// A finished picture on its way into the window.
#pragma once

#include "renderer/image/image.h"
#include "renderer/window/gl_objects.h"
#include "renderer/window/view_renderer.h"

namespace foveola {

/// Needs a current context in all that it does.
class PictureTexture {
 public:
  PictureTexture();

  /// Fills `part` of the framebuffer with the picture, which has as many pixels, its top row on
  /// top.
  void draw(const ByteImage& picture, const WindowPart& part);

 private:
  void resize(const IVec2& size);

  GlProgram program_;
  GlTexture texture_;
  GlVertexArray no_vertices_;
  IVec2 size_{0};
};

}  // namespace foveola
