#include "renderer/headset/eye_views.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <epoxy/gl.h>
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

/// Our shaders' colours are already encoded: they are written unchanged, and the runtime decodes
/// them, since the pictures are in sRGB.
std::int64_t chosen_format(const XrInstanceOwner& instance, XrSession session) {
  std::uint32_t count = 0;
  instance.require(instance.xr().EnumerateSwapchainFormats(session, 0, &count, nullptr),
                   "xrEnumerateSwapchainFormats");
  std::vector<std::int64_t> formats(count);
  instance.require(instance.xr().EnumerateSwapchainFormats(session, count, &count, formats.data()),
                   "xrEnumerateSwapchainFormats");
  for (const std::int64_t wanted : {GL_SRGB8_ALPHA8, GL_SRGB8}) {
    if (std::ranges::find(formats, wanted) != formats.end()) {
      return wanted;
    }
  }
  throw Error("headset", "its runtime takes no pictures of 8 bits in sRGB",
              "update the headset's runtime");
}

constexpr int cells = 64;          // in each direction
constexpr int cells_of_digit = 4;  // as in SeenPart
constexpr int points_of_cell = 4;  // in each direction; as many more surround the cell

/// Positive to the left of the line from `a` to `b`.
float side_of(const Vec2& a, const Vec2& b, const Vec2& point) {
  return (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x);
}

bool is_hidden(const Vec2& point, const HiddenTriangles& hidden) {
  for (std::size_t i = 0; i + 2 < hidden.size(); i += 3) {
    const float first = side_of(hidden[i], hidden[i + 1], point);
    const float second = side_of(hidden[i + 1], hidden[i + 2], point);
    const float third = side_of(hidden[i + 2], hidden[i], point);
    const bool is_inside = (first >= 0.0F && second >= 0.0F && third >= 0.0F) ||
                           (first <= 0.0F && second <= 0.0F && third <= 0.0F);
    if (is_inside) {
      return true;
    }
  }
  return false;
}

/// An eye in the head, which looks along its own -z.
struct EyeInHead {
  Quat eye_from_head;
  Vec2 low;  ///< of its view on the plane at distance 1
  Vec2 high;

  EyeInHead(const XrView& eye, const Quat& head)
      : eye_from_head(glm::conjugate(orientation_of(eye.pose)) * head),
        low(std::tan(eye.fov.angleLeft), std::tan(eye.fov.angleDown)),
        high(std::tan(eye.fov.angleRight), std::tan(eye.fov.angleUp)) {}

  bool sees(const Vec3& direction_in_head, const HiddenTriangles& hidden) const {
    const Vec3 direction = eye_from_head * direction_in_head;
    if (direction.z >= 0.0F) {
      return false;
    }
    const Vec2 point = Vec2(direction) / -direction.z;
    return glm::all(glm::greaterThanEqual(point, low)) &&
           glm::all(glm::lessThanEqual(point, high)) && !is_hidden(point, hidden);
  }
};

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

/// The sides of a view on the plane at distance 1.
struct Sides {
  double left = 0.0;
  double right = 0.0;
  double up = 0.0;
  double down = 0.0;
};

Sides sides_of(const XrFovf& fov) {
  return {.left = std::tan(fov.angleLeft),
          .right = std::tan(fov.angleRight),
          .up = std::tan(fov.angleUp),
          .down = std::tan(fov.angleDown)};
}

FieldOfView field_of_view_between(const Sides& sides) {
  const double width = sides.right - sides.left;
  const double height = sides.up - sides.down;
  return {.horizontal_deg = degrees(2.0 * std::atan(0.5 * width)),
          .vertical_deg = degrees(2.0 * std::atan(0.5 * height)),
          .lens = {.axis = {static_cast<float>(-sides.left / width),
                            static_cast<float>(sides.up / height)}}};
}

}  // namespace

EyeImages::EyeImages(const XrInstanceOwner& instance, XrSession session, std::size_t eye)
    : instance_(&instance), size_px_(instance.eye_px()[eye]), swapchain_(make_swapchain(session)) {
  make_framebuffers();
}

XrSwapchain EyeImages::make_swapchain(XrSession session) const {
  XrSwapchainCreateInfo info{XR_TYPE_SWAPCHAIN_CREATE_INFO};
  info.usageFlags = XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT;
  info.format = chosen_format(*instance_, session);
  info.sampleCount = info.faceCount = info.arraySize = info.mipCount = 1;
  info.width = static_cast<std::uint32_t>(size_px_.x);
  info.height = static_cast<std::uint32_t>(size_px_.y);
  XrSwapchain made = XR_NULL_HANDLE;
  instance_->require(instance_->xr().CreateSwapchain(session, &info, &made), "xrCreateSwapchain");
  return made;
}

void EyeImages::make_framebuffers() {
  const XrFunctions& xr = instance_->xr();
  std::uint32_t count = 0;
  instance_->require(xr.EnumerateSwapchainImages(swapchain_, 0, &count, nullptr),
                     "xrEnumerateSwapchainImages");
  std::vector<XrSwapchainImageOpenGLKHR> images(count, {XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR});
  instance_->require(
      xr.EnumerateSwapchainImages(swapchain_, count, &count,
                                  reinterpret_cast<XrSwapchainImageBaseHeader*>(images.data())),
      "xrEnumerateSwapchainImages");
  depths_ = make_gl<GlRenderbuffer>(glGenRenderbuffers);
  glBindRenderbuffer(GL_RENDERBUFFER, depths_.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size_px_.x, size_px_.y);
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  for (const XrSwapchainImageOpenGLKHR& image : images) {
    framebuffers_.push_back(make_gl<GlFramebuffer>(glGenFramebuffers));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_.back().name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, image.image, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depths_.name());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw Error("headset", "OpenGL cannot draw into the runtime's pictures",
                  "update the graphics driver and the headset's runtime");
    }
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void EyeImages::begin() {
  std::uint32_t index = 0;
  instance_->require(instance_->xr().AcquireSwapchainImage(swapchain_, nullptr, &index),
                     "xrAcquireSwapchainImage");
  XrSwapchainImageWaitInfo wait{XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO};
  wait.timeout = XR_INFINITE_DURATION;
  instance_->require(instance_->xr().WaitSwapchainImage(swapchain_, &wait), "xrWaitSwapchainImage");
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[index].name());
  glViewport(0, 0, size_px_.x, size_px_.y);
  glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void EyeImages::end() {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  instance_->require(instance_->xr().ReleaseSwapchainImage(swapchain_, nullptr),
                     "xrReleaseSwapchainImage");
}

XrSwapchainSubImage EyeImages::sub_image() const {
  return {swapchain_, {{0, 0}, {size_px_.x, size_px_.y}}, 0};
}

FieldOfView field_of_view_of(const XrFovf& fov) { return field_of_view_between(sides_of(fov)); }

Viewport viewport_of(const XrView& eye, const Quat& world_from_room) {
  return viewport_of(world_from_room * orientation_of(eye.pose), field_of_view_of(eye.fov));
}

Mat3 part_from_canvas(const std::array<XrView, 2>& eyes, std::size_t eye, const Quat& head,
                      float distance_m) {
  const auto position_of = [](const XrView& one) {
    const XrVector3f& p = one.pose.position;
    return Vec3(p.x, p.y, p.z);
  };
  const auto size_of = [](const Sides& sides) {
    return Vec2(sides.right - sides.left, sides.up - sides.down);
  };
  // The canvas's centre is straight ahead, and its sides are as long as the left eye's picture's,
  // seen from between the eyes.
  const Vec2 canvas_m = distance_m * size_of(sides_of(eyes[0].fov));
  const Mat3 head_from_canvas(Vec3(canvas_m.x, 0.0F, 0.0F), Vec3(0.0F, -canvas_m.y, 0.0F),
                              Vec3(-0.5F * canvas_m.x, 0.5F * canvas_m.y, -distance_m));
  const Quat eye_from_room = glm::conjugate(orientation_of(eyes[eye].pose));
  const Vec3 middle = 0.5F * (position_of(eyes[0]) + position_of(eyes[1]));
  Mat3 eye_from_canvas = glm::mat3_cast(eye_from_room * head) * head_from_canvas;
  eye_from_canvas[2] += eye_from_room * (middle - position_of(eyes[eye]));
  const Sides sides = sides_of(eyes[eye].fov);
  const Vec2 size = size_of(sides);
  const auto left = static_cast<float>(-sides.left);
  const auto up = static_cast<float>(sides.up);
  // A point (x, y, z) appears at ((left + x / -z) / width, (up - y / -z) / height).
  const Mat3 part_from_eye(Vec3(1.0F / size.x, 0.0F, 0.0F), Vec3(0.0F, -1.0F / size.y, 0.0F),
                           Vec3(-left / size.x, -up / size.y, -1.0F));
  return part_from_eye * eye_from_canvas;
}

FieldOfView field_of_view_of_both(const std::array<XrView, 2>& eyes, const Quat& head) {
  const double farthest = std::tan(radians(80.0));
  constexpr double unknown = std::numeric_limits<double>::infinity();
  Sides both{.left = unknown, .right = -unknown, .up = -unknown, .down = unknown};
  for (const XrView& eye : eyes) {
    const Quat head_from_eye = glm::conjugate(head) * orientation_of(eye.pose);
    const Sides sides = sides_of(eye.fov);
    for (const double x : {sides.left, sides.right}) {
      for (const double y : {sides.up, sides.down}) {
        const Vec3 corner = head_from_eye * Vec3(static_cast<float>(x), static_cast<float>(y), -1);
        const auto on_plane = [&](float along) {
          const double distance = std::max(-static_cast<double>(corner.z), 1e-6);
          return std::clamp(along / distance, -farthest, farthest);
        };
        both.left = std::min(both.left, on_plane(corner.x));
        both.right = std::max(both.right, on_plane(corner.x));
        both.up = std::max(both.up, on_plane(corner.y));
        both.down = std::min(both.down, on_plane(corner.y));
      }
    }
  }
  return field_of_view_between(both);
}

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

std::shared_ptr<const SeenPart> seen_by_eyes(const std::array<XrView, 2>& eyes, const Quat& head,
                                             const FieldOfView& both,
                                             const std::array<HiddenTriangles, 2>& hidden) {
  const std::array in_head{EyeInHead(eyes[0], head), EyeInHead(eyes[1], head)};
  const Viewport view = viewport_of(Quat(1.0F, 0.0F, 0.0F, 0.0F), both);
  const auto is_point_seen = [&](int column, int row) {
    const Vec2 plane = Vec2(static_cast<float>(column), static_cast<float>(row)) /
                       static_cast<float>(cells * points_of_cell);
    const Vec3 direction = view.direction(plane);
    return in_head[0].sees(direction, hidden[0]) || in_head[1].sees(direction, hidden[1]);
  };
  const auto is_cell_seen = [&](int column, int row) {
    for (int y = -1; y <= points_of_cell + 1; ++y) {
      for (int x = -1; x <= points_of_cell + 1; ++x) {
        if (is_point_seen(column * points_of_cell + x, row * points_of_cell + y)) {
          return true;
        }
      }
    }
    return false;
  };
  std::vector<std::string> rows;
  int seen = 0;
  for (int row = 0; row < cells; ++row) {
    std::string digits;
    for (int column = 0; column < cells; column += cells_of_digit) {
      int bits = 0;
      for (int cell = 0; cell < cells_of_digit; ++cell) {
        const int bit = is_cell_seen(column + cell, row) ? 1 : 0;
        bits = 2 * bits + bit;
        seen += bit;
      }
      digits += "0123456789abcdef"[bits];
    }
    rows.push_back(digits);
  }
  return seen == 0 || seen == cells * cells ? nullptr : std::make_shared<const SeenPart>(rows);
}

}  // namespace foveola
