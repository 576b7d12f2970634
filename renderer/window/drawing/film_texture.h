// The film on the graphics card: its pyramid in one texture, updated where it changed.
#pragma once

#include "renderer/window/drawing/film_mirror.h"
#include "renderer/window/drawing/gl_objects.h"

namespace foveola {

/// Needs a current context throughout.
class FilmTexture {
 public:
  /// Initially unsampled. Throws Error if the card does not support textures of that size.
  explicit FilmTexture(const PyramidAtlas& atlas);

  void apply(const FilmUpdate& update);

  GLuint name() const { return texture_.name(); }
  const PyramidAtlas& atlas() const { return atlas_; }

 private:
  PyramidAtlas atlas_;
  GlProgram program_;
  GlTexture texture_;
  GlFramebuffer framebuffer_;
  GlBuffer rectangles_;
  GlVertexArray layout_;
};

}  // namespace foveola
