#include "renderer/window/drawing/film_texture.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/window/drawing/view_renderer.h"

namespace foveola {
namespace {

const void* offset_in_buffer(std::size_t bytes) {
  // OpenGL's interface requires it.
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr)
}

void require_room_for(const IVec2& size) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  if (std::max(size.x, size.y) > largest) {
    throw Error("--size",
                fmt::format("the film needs {}x{} texels, and this graphics card has {}x{}", size.x,
                            size.y, largest, largest),
                "choose a smaller film");
  }
}

}  // namespace

FilmTexture::FilmTexture(const PyramidAtlas& atlas)
    : atlas_(atlas),
      program_(make_gl_program(atlas_vertex_shader, atlas_fragment_shader)),
      texture_(make_gl<GlTexture>(glGenTextures)),
      framebuffer_(make_gl<GlFramebuffer>(glGenFramebuffers)),
      rectangles_(make_gl<GlBuffer>(glGenBuffers)),
      layout_(make_gl<GlVertexArray>(glGenVertexArrays)) {
  require_room_for(atlas.size());
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, atlas.size().x, atlas.size().y, 0, GL_RGBA, GL_FLOAT,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Error("OpenGL", "this graphics card cannot draw to 16-bit textures",
                "update the graphics driver, or use Mesa's");
  }
  glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);

  glBindVertexArray(layout_.name());
  glBindBuffer(GL_ARRAY_BUFFER, rectangles_.name());
  glVertexAttribIPointer(0, 4, GL_UNSIGNED_SHORT, sizeof(AtlasRectangle), offset_in_buffer(0));
  glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, sizeof(AtlasRectangle),
                        offset_in_buffer(offsetof(AtlasRectangle, value)));
  for (const GLuint attribute : {0U, 1U}) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribDivisor(attribute, 1);
  }
  glBindVertexArray(0);
  check_gl("film texture");
}

void FilmTexture::apply(const FilmUpdate& update) {
  if (update.empty()) {
    return;
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, atlas_.size().x, atlas_.size().y);
  glUseProgram(program_.name());
  glUniform2f(glGetUniformLocation(program_.name(), "atlas_size"),
              static_cast<float>(atlas_.size().x), static_cast<float>(atlas_.size().y));
  glBindVertexArray(layout_.name());
  glBindBuffer(GL_ARRAY_BUFFER, rectangles_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(update.size() * sizeof(AtlasRectangle)),
               update.data(), GL_STREAM_DRAW);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(update.size()));
  glBindVertexArray(0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace foveola
