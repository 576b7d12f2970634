#include "renderer/window/view_renderer.h"

#include <cmath>

#include <glm/gtc/type_ptr.hpp>

#include "renderer/window/view_shaders.h"

namespace foveola {
namespace {

constexpr GLint film_unit = 0;

void bind(GLint unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

}  // namespace

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
