#include "renderer/window/view_renderer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/gtc/type_ptr.hpp>

#include "renderer/window/view_shaders.h"

namespace foveola {
namespace {

constexpr GLint film_unit = 0;
constexpr GLint density_unit = 1;

void set_smooth(GLuint texture) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

void bind(GLint unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

}  // namespace

ViewRenderer::ViewRenderer()
    : program_(make_gl_program(view_vertex_shader, view_fragment_shader)),
      no_vertices_(make_gl<GlVertexArray>(glGenVertexArrays)),
      density_(make_gl<GlTexture>(glGenTextures)) {
  set_smooth(density_.name());
  glDisable(GL_DITHER);
  check_gl("view renderer");
}

void ViewRenderer::draw(const FilmTexture& film, const Viewport& viewport, const WindowPart& part,
                        const ViewLook& look, const ViewOverlays& overlays) {
  glViewport(part.origin.x, part.origin.y, part.size.x, part.size.y);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glUseProgram(program_.name());
  set_film(film, look);
  set_view(viewport, part);
  set_overlays(overlays);
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

void ViewRenderer::set_film(const FilmTexture& film, const ViewLook& look) {
  bind(film_unit, film.name());
  glUniform1i(uniform("atlas"), film_unit);
  const std::vector<PyramidAtlas::Level>& levels = film.atlas().levels();
  std::vector<GLint> places;
  for (const PyramidAtlas::Level& level : levels) {
    places.insert(places.end(), {level.origin.x, level.origin.y, level.size.x, level.size.y});
  }
  glUniform1i(uniform("levels"), static_cast<GLint>(levels.size()));
  glUniform4iv(uniform("level_places"), static_cast<GLsizei>(levels.size()), places.data());
  const IVec2& size = levels.front().size;
  glUniform2f(uniform("film_size"), static_cast<float>(size.x), static_cast<float>(size.y));
  glUniform1i(uniform("fill_unsampled"), look.fill_unsampled ? 1 : 0);
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

void ViewRenderer::set_overlays(const ViewOverlays& overlays) {
  assert(overlays.rings_rad.size() <= ViewOverlays::most_rings);
  glUniform1i(uniform("show_gaze"), overlays.shows_gaze ? 1 : 0);
  glUniform3f(uniform("gaze"), overlays.gaze.x, overlays.gaze.y, overlays.gaze.z);
  const Vec3 target = overlays.target.value_or(overlays.gaze);
  glUniform1i(uniform("show_target"), overlays.target ? 1 : 0);
  glUniform3f(uniform("target"), target.x, target.y, target.z);
  glUniform1i(uniform("rings"), static_cast<GLint>(overlays.rings_rad.size()));
  if (!overlays.rings_rad.empty()) {
    glUniform1fv(uniform("ring_rad"), static_cast<GLsizei>(overlays.rings_rad.size()),
                 overlays.rings_rad.data());
  }
  set_offers(overlays.offers);
  bind(density_unit, density_.name());
  glUniform1i(uniform("density"), density_unit);
  glUniform1i(uniform("show_density"), overlays.density ? 1 : 0);
  if (overlays.density) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R16F, overlays.density->width, overlays.density->height, 0,
                 GL_RED, GL_FLOAT, overlays.density->values.data());
  }
}

void ViewRenderer::set_offers(const std::vector<OfferRing>& offers) {
  assert(offers.size() <= ViewOverlays::most_offers);
  std::vector<glm::vec4> places;
  std::vector<GLint> highlights;
  for (const OfferRing& offer : offers) {
    places.emplace_back(offer.direction, offer.radius_rad);
    highlights.push_back(offer.is_highlighted ? 1 : 0);
  }
  const auto count = static_cast<GLsizei>(offers.size());
  glUniform1i(uniform("offers"), count);
  if (count > 0) {
    glUniform4fv(uniform("offer_place"), count, glm::value_ptr(places.front()));
    glUniform1iv(uniform("offer_is_highlighted"), count, highlights.data());
  }
}

}  // namespace foveola
