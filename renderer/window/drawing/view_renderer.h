// Draws a display's view of a film, or a finished picture, on the graphics card.
#pragma once

#include <vector>

#include "renderer/image/image.h"
#include "renderer/image/tone_mapping.h"
#include "renderer/view/viewport.h"
#include "renderer/window/drawing/film_texture.h"
#include "renderer/window/drawing/gl_objects.h"

namespace foveola {

/// Fill rectangles of the atlas (AtlasRectangle): each instance is a strip of four vertices.
extern const char* const atlas_vertex_shader;
extern const char* const atlas_fragment_shader;

/// Show a part of the film as viewport_image does, as sRGB.
extern const char* const view_vertex_shader;
extern const char* const view_fragment_shader;

/// A finished picture, pixel by pixel, with the view's vertex shader.
extern const char* const picture_fragment_shader;

/// The appearance of the film.
struct ViewLook {
  double exposure_stops = 0.0;
  bool fill_unsampled = false;  ///< UnsampledPixels::filled
  ToneCurve curve = ToneCurve::plain;
};

/// A part of the window, in pixels from its bottom left.
struct WindowPart {
  IVec2 origin{0};
  IVec2 size{0};
};

/// Shows the film as viewport_image and display_image do, up to the rounding of 16-bit texels.
/// Needs a current context throughout.
class ViewRenderer {
 public:
  ViewRenderer();
  void draw(const FilmTexture& film, const Viewport& viewport, const WindowPart& part,
            const ViewLook& look);

 private:
  void set_film(const FilmTexture& film, const ViewLook& look);
  void set_view(const Viewport& viewport, const WindowPart& part);
  GLint uniform(const char* name) const { return glGetUniformLocation(program_.name(), name); }

  GlProgram program_;
  GlVertexArray no_vertices_;
  std::vector<GLint> level_places_;  ///< kept to avoid allocations per frame
};

/// Needs a current context throughout.
class PictureTexture {
 public:
  PictureTexture();

  /// Fills `part` of the framebuffer with the picture of the same size, its top row on top.
  void draw(const ByteImage& picture, const WindowPart& part);

 private:
  void resize(const IVec2& size);

  GlProgram program_;
  GlTexture texture_;
  GlVertexArray no_vertices_;
  IVec2 size_{0};
};

}  // namespace foveola
