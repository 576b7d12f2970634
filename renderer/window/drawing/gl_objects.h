// RAII owners of OpenGL objects. All of it needs a current OpenGL 3.3 context.
#pragma once

#include <string>
#include <utility>

#include <epoxy/gl.h>

namespace foveola {

/// The name of an object, deleted with it. Remove: deletes one name.
template <void (*Remove)(GLuint)>
class GlObject {
 public:
  GlObject() = default;
  explicit GlObject(GLuint name) : name_(name) {}
  ~GlObject() { reset(); }
  GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    reset();
    name_ = std::exchange(other.name_, 0);
    return *this;
  }

  GLuint name() const { return name_; }

 private:
  void reset() {
    if (name_ != 0) {
      Remove(name_);
    }
  }

  GLuint name_ = 0;
};

inline void remove_gl_texture(GLuint name) { glDeleteTextures(1, &name); }
inline void remove_gl_framebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline void remove_gl_renderbuffer(GLuint name) { glDeleteRenderbuffers(1, &name); }
inline void remove_gl_buffer(GLuint name) { glDeleteBuffers(1, &name); }
inline void remove_gl_vertex_array(GLuint name) { glDeleteVertexArrays(1, &name); }
inline void remove_gl_program(GLuint name) { glDeleteProgram(name); }
inline void remove_gl_shader(GLuint name) { glDeleteShader(name); }

using GlTexture = GlObject<remove_gl_texture>;
using GlFramebuffer = GlObject<remove_gl_framebuffer>;
using GlRenderbuffer = GlObject<remove_gl_renderbuffer>;
using GlBuffer = GlObject<remove_gl_buffer>;
using GlVertexArray = GlObject<remove_gl_vertex_array>;
using GlProgram = GlObject<remove_gl_program>;
using GlShader = GlObject<remove_gl_shader>;

/// Creates an object. generate: the function for names of its kind, such as glGenTextures.
template <typename Object>
Object make_gl(void (*generate)(GLsizei count, GLuint* names)) {
  GLuint name = 0;
  generate(1, &name);
  return Object(name);
}

/// Compiles and links GLSL. Throws Error with the compiler's message.
GlProgram make_gl_program(const std::string& vertex_source, const std::string& fragment_source);

/// Throws Error at `where` if an OpenGL error occurred since the last call.
void check_gl(const std::string& where);

}  // namespace foveola
