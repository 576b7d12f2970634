// The programs that run on the graphics card, in GLSL 3.30.
#pragma once

namespace foveola {

/// Fills rectangles of the atlas (AtlasRectangle): four vertices of a strip an instance.
extern const char* const atlas_vertex_shader;
extern const char* const atlas_fragment_shader;

/// Shows a part of the film as viewport_image does, as sRGB.
extern const char* const view_vertex_shader;
extern const char* const view_fragment_shader;

/// A finished picture, pixel by pixel. Its vertex shader is the view's.
extern const char* const picture_fragment_shader;

}  // namespace foveola
