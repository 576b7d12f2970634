#include "renderer/window/picture_texture.h"

#include "renderer/window/view_shaders.h"

namespace foveola {

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
