#include "renderer/window/drawing/gl_objects.h"

#include <fmt/format.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

constexpr const char* driver_remedy = "update the graphics driver, or use Mesa's";

GlShader compile(GLenum kind, const std::string& source) {
  GlShader shader(glCreateShader(kind));
  const char* text = source.c_str();
  glShaderSource(shader.name(), 1, &text, nullptr);
  glCompileShader(shader.name());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (compiled != GL_TRUE) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader.name(), static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    throw Error("OpenGL", "a shader does not compile: " + log, driver_remedy);
  }
  return shader;
}

}  // namespace

GlProgram make_gl_program(const std::string& vertex_source, const std::string& fragment_source) {
  const GlShader vertex = compile(GL_VERTEX_SHADER, vertex_source);
  const GlShader fragment = compile(GL_FRAGMENT_SHADER, fragment_source);
  GlProgram program(glCreateProgram());
  glAttachShader(program.name(), vertex.name());
  glAttachShader(program.name(), fragment.name());
  glLinkProgram(program.name());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    throw Error("OpenGL", "shaders do not link", driver_remedy);
  }
  return program;
}

void check_gl(const std::string& where) {
  const GLenum fault = glGetError();
  if (fault != GL_NO_ERROR) {
    throw Error("OpenGL", fmt::format("{}: error 0x{:04x}", where, fault), driver_remedy);
  }
}

}  // namespace foveola
