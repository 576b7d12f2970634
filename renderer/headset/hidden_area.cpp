#include "renderer/headset/hidden_area.h"

#include <cmath>
#include <vector>

namespace foveola {
namespace {

const char* const vertex_shader = R"(#version 330 core
layout(location = 0) in vec2 corner;  // on the plane at distance 1
uniform vec2 low;                     // of the view there
uniform vec2 high;

void main() {
  gl_Position = vec4(2.0 * (corner - low) / (high - low) - 1.0, -1.0, 1.0);
}
)";

const char* const fragment_shader = R"(#version 330 core
out vec4 color;

void main() { color = vec4(0.0, 0.0, 0.0, 1.0); }
)";

HiddenTriangles hidden_triangles(const XrInstanceOwner& instance, XrSession session,
                                 std::size_t eye) {
  if (!instance.is_enabled(XR_KHR_VISIBILITY_MASK_EXTENSION_NAME)) {
    return {};
  }
  const auto get = instance.function<PFN_xrGetVisibilityMaskKHR>("xrGetVisibilityMaskKHR");
  XrVisibilityMaskKHR mask{XR_TYPE_VISIBILITY_MASK_KHR};
  const auto ask = [&] {
    instance.require(
        get(session, XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO, static_cast<std::uint32_t>(eye),
            XR_VISIBILITY_MASK_TYPE_HIDDEN_TRIANGLE_MESH_KHR, &mask),
        "xrGetVisibilityMaskKHR");
  };
  ask();
  std::vector<XrVector2f> vertices(mask.vertexCountOutput);
  std::vector<std::uint32_t> indices(mask.indexCountOutput);
  mask.vertexCapacityInput = mask.vertexCountOutput;
  mask.vertices = vertices.data();
  mask.indexCapacityInput = mask.indexCountOutput;
  mask.indices = indices.data();
  if (!indices.empty()) {
    ask();
  }
  HiddenTriangles triangles;
  for (const std::uint32_t index : indices) {
    triangles.emplace_back(vertices.at(index).x, vertices.at(index).y);
  }
  return triangles;
}

}  // namespace

HiddenArea::HiddenArea(const XrInstanceOwner& instance, XrSession session, std::size_t eye)
    : triangles_(hidden_triangles(instance, session, eye)) {
  if (is_empty()) {
    return;
  }
  program_ = make_gl_program(vertex_shader, fragment_shader);
  vertices_ = make_gl<GlVertexArray>(glGenVertexArrays);
  corners_ = make_gl<GlBuffer>(glGenBuffers);
  glBindVertexArray(vertices_.name());
  glBindBuffer(GL_ARRAY_BUFFER, corners_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles_.size() * sizeof(Vec2)),
               triangles_.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  check_gl("hidden area");
}

void HiddenArea::draw(const XrFovf& fov) const {
  glUseProgram(program_.name());
  glUniform2f(glGetUniformLocation(program_.name(), "low"), std::tan(fov.angleLeft),
              std::tan(fov.angleDown));
  glUniform2f(glGetUniformLocation(program_.name(), "high"), std::tan(fov.angleRight),
              std::tan(fov.angleUp));
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glBindVertexArray(vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles_.size()));
  glBindVertexArray(0);
}

}  // namespace foveola
