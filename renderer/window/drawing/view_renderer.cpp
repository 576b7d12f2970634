#include "renderer/window/drawing/view_renderer.h"

#include <cmath>

#include <glm/gtc/type_ptr.hpp>

namespace foveola {
namespace {

constexpr GLint film_unit = 0;

void bind(GLint unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

}  // namespace

const char* const atlas_vertex_shader = R"(#version 330 core
layout(location = 0) in uvec4 rectangle;  // x, y, width, height
layout(location = 1) in vec4 value;
uniform vec2 atlas_size;
flat out vec4 cell;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 place = (vec2(rectangle.xy) + corner * vec2(rectangle.zw)) / atlas_size;
  gl_Position = vec4(2.0 * place - 1.0, 0.0, 1.0);
  cell = value;
}
)";

const char* const atlas_fragment_shader = R"(#version 330 core
flat in vec4 cell;
out vec4 color;

void main() {
  color = min(cell, vec4(65504.0));  // maximum of a half float
}
)";

const char* const view_vertex_shader = R"(#version 330 core
void main() {
  // One triangle over all of the viewport.
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(4.0 * corner - 1.0, 0.0, 1.0);
}
)";

const char* const picture_fragment_shader = R"(#version 330 core
uniform sampler2D picture;
uniform ivec2 top_left;  // its first pixel in the window, from the bottom left
out vec4 color;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  color = texelFetch(picture, ivec2(at.x - top_left.x, top_left.y - at.y), 0);
}
)";

const char* const view_fragment_shader = R"(#version 330 core
const int most_levels = 17;
const float pi = 3.14159265358979;

uniform sampler2D atlas;
uniform int levels;
uniform ivec4 level_places[most_levels];  // origin and size, cells
uniform vec2 film_size;                   // pixels
uniform bool fill_unsampled;
uniform float exposure;
uniform bool is_filmic;  // otherwise the plain curve

uniform vec2 view_origin;  // of the view in the window, pixels from the bottom left
uniform vec2 view_size;
uniform mat3 world_from_head;
uniform vec2 half_size;  // of the image plane at distance 1
uniform vec2 lens_axis;
uniform vec2 lens;  // k1, k2

out vec4 color;

// A point of the view, (0, 0) top left, as an offset from the lens' axis on the image plane.
vec2 plane_offset(vec2 plane) { return 2.0 * (plane - lens_axis) * half_size; }

float magnification(float d2) { return 1.0 + d2 * (lens.x + d2 * lens.y); }
float growth(float d2) { return 1.0 + d2 * (3.0 * lens.x + d2 * 5.0 * lens.y); }

vec3 world_direction(vec2 offset) {
  vec2 seen = magnification(dot(offset, offset)) * offset;
  return normalize(world_from_head * vec3(seen.x, -seen.y, -1.0));
}

vec2 equirect(vec3 direction) {
  float azimuth = atan(direction.x, -direction.z);
  float elevation = atan(direction.y, length(direction.xz));
  return vec2(azimuth / (2.0 * pi) + 0.5, 0.5 - elevation / pi);
}

// The level whose cells are as high as a pixel of the view is wide (Viewport::sr_per_area).
float level_for(vec2 offset) {
  float d2 = dot(offset, offset);
  float larger = magnification(d2);
  float area = 4.0 * half_size.x * half_size.y * larger * growth(d2);
  float cosine = inversesqrt(1.0 + d2 * larger * larger);
  float sr = area * cosine * cosine * cosine / (view_size.x * view_size.y);
  return max(0.0, log2(sqrt(sr) * film_size.y / pi));
}

// A cell of a level; beyond a pole the same row continues half an image further.
vec4 cell(ivec4 place, ivec2 at) {
  if (at.y < 0 || at.y >= place.w) {
    at = ivec2(at.x + place.z / 2, at.y < 0 ? -1 - at.y : 2 * place.w - 1 - at.y);
  }
  at.x += at.x < 0 ? place.z : 0;
  at.x -= at.x >= place.z ? place.z : 0;
  return texelFetch(atlas, place.xy + at, 0);
}

// Colour times weight, and weight.
vec4 bilinear(int level, vec2 image) {
  ivec4 place = level_places[level];
  vec2 at = image * film_size / float(1 << level) - 0.5;
  vec2 corner = floor(at);
  vec2 t = at - corner;
  ivec2 first = ivec2(corner);
  vec4 upper = mix(cell(place, first), cell(place, first + ivec2(1, 0)), t.x);
  vec4 lower = mix(cell(place, first + ivec2(0, 1)), cell(place, first + ivec2(1, 1)), t.x);
  return mix(upper, lower, t.y);
}

vec3 film_color(vec2 image, float level) {
  float shown = min(level, float(levels - 1));
  int finer = int(shown);
  vec4 known = bilinear(finer, image);
  if (shown > float(finer)) {
    known = mix(known, bilinear(finer + 1, image), shown - float(finer));
  }
  if (fill_unsampled) {
    for (int l = finer + 1; l < levels && known.a < 0.999; ++l) {
      vec4 coarser = bilinear(l, image);
      if (coarser.a > 0.0) {
        known += (1.0 - known.a) * min(exp2(2.0 * float(l)), 1.0 / coarser.a) * coarser;
      }
    }
  }
  return known.a > 0.0 ? known.rgb / known.a : vec3(0.0);
}

// The function filmic() of tone_mapping.h.
vec3 filmic(vec3 linear) {
  vec3 x = 0.6 * clamp(linear, 0.0, 1e6);
  return min((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 1.0);
}

vec3 srgb(vec3 linear) {
  vec3 x = clamp(linear, 0.0, 1.0);
  return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, lessThanEqual(x, vec3(0.0031308)));
}

void main() {
  vec2 plane = (gl_FragCoord.xy - view_origin) / view_size;
  plane.y = 1.0 - plane.y;
  vec2 offset = plane_offset(plane);
  vec3 direction = world_direction(offset);
  vec3 exposed = exposure * film_color(equirect(direction), level_for(offset));
  color = vec4(srgb(is_filmic ? filmic(exposed) : exposed), 1.0);
}
)";

ViewRenderer::ViewRenderer()
    : program_(make_gl_program(view_vertex_shader, view_fragment_shader)),
      no_vertices_(make_gl<GlVertexArray>(glGenVertexArrays)) {
  glDisable(GL_DITHER);
  check_gl("view renderer");
}

void ViewRenderer::draw(const FilmTexture& film, const Viewport& viewport, const WindowPart& part,
                        const ViewLook& look) {
  glViewport(part.origin.x, part.origin.y, part.size.x, part.size.y);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glUseProgram(program_.name());
  set_film(film, look);
  set_view(viewport, part);
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

void ViewRenderer::set_film(const FilmTexture& film, const ViewLook& look) {
  bind(film_unit, film.name());
  glUniform1i(uniform("atlas"), film_unit);
  const std::vector<PyramidAtlas::Level>& levels = film.atlas().levels();
  level_places_.clear();
  for (const PyramidAtlas::Level& level : levels) {
    level_places_.insert(level_places_.end(),
                         {level.origin.x, level.origin.y, level.size.x, level.size.y});
  }
  glUniform1i(uniform("levels"), static_cast<GLint>(levels.size()));
  glUniform4iv(uniform("level_places"), static_cast<GLsizei>(levels.size()), level_places_.data());
  const IVec2& size = levels.front().size;
  glUniform2f(uniform("film_size"), static_cast<float>(size.x), static_cast<float>(size.y));
  glUniform1i(uniform("fill_unsampled"), look.fill_unsampled ? 1 : 0);
  glUniform1i(uniform("is_filmic"), look.curve == ToneCurve::filmic ? 1 : 0);
  glUniform1f(uniform("exposure"), static_cast<float>(std::exp2(look.exposure_stops)));
}

void ViewRenderer::set_view(const Viewport& viewport, const WindowPart& part) {
  glUniform2f(uniform("view_origin"), static_cast<float>(part.origin.x),
              static_cast<float>(part.origin.y));
  glUniform2f(uniform("view_size"), static_cast<float>(part.size.x),
              static_cast<float>(part.size.y));
  const glm::mat3 world_from_head = glm::mat3_cast(viewport.head());
  glUniformMatrix3fv(uniform("world_from_head"), 1, GL_FALSE, glm::value_ptr(world_from_head));
  glUniform2f(uniform("half_size"), viewport.half_size().x, viewport.half_size().y);
  const RadialLens& lens = viewport.lens();
  glUniform2f(uniform("lens_axis"), lens.axis.x, lens.axis.y);
  glUniform2f(uniform("lens"), lens.k1, lens.k2);
}

PictureTexture::PictureTexture()
    : program_(make_gl_program(view_vertex_shader, picture_fragment_shader)),
      texture_(make_gl<GlTexture>(glGenTextures)),
      no_vertices_(make_gl<GlVertexArray>(glGenVertexArrays)) {
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  check_gl("picture texture");
}

void PictureTexture::draw(const ByteImage& picture, const WindowPart& part) {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  resize({picture.width, picture.height});
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE,
                  picture.pixels.data());
  glViewport(part.origin.x, part.origin.y, part.size.x, part.size.y);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glUseProgram(program_.name());
  glUniform1i(glGetUniformLocation(program_.name(), "picture"), 0);
  glUniform2i(glGetUniformLocation(program_.name(), "top_left"), part.origin.x,
              part.origin.y + part.size.y - 1);
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

void PictureTexture::resize(const IVec2& size) {
  if (size == size_) {
    return;
  }
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.x, size.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  size_ = size;
}

}  // namespace foveola
