#include "tests/end_to_end/first_look_files.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>

#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

constexpr double pi = std::numbers::pi;

/// Triangles with vertices of their own.
class Triangles {
 public:
  /// One without area, as at the poles of a surface, is left out.
  void add_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    if (glm::length(glm::cross(b - a, c - a)) < 1e-12F) {
      return;
    }
    corners_.insert(corners_.end(), {a, b, c});
  }

  /// a, b, c, d: counter-clockwise as seen from where it shall be seen.
  void add_quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    add_triangle(a, b, c);
    add_triangle(a, c, d);
  }

  /// The points of `surface` over the unit square, seen from where u to the right has v upwards.
  void add_surface(int columns, int rows, const std::function<Vec3(double, double)>& surface) {
    const auto at = [&](int column, int row) {
      return surface(static_cast<double>(column) / columns, static_cast<double>(row) / rows);
    };
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        add_quad(at(column, row), at(column + 1, row), at(column + 1, row + 1),
                 at(column, row + 1));
      }
    }
  }

  /// From `lower` to `upper`, seen from outside.
  void add_box(const Vec3& lower, const Vec3& upper) {
    const auto corner = [&](int x, int y, int z) {
      return Vec3(x == 0 ? lower.x : upper.x, y == 0 ? lower.y : upper.y,
                  z == 0 ? lower.z : upper.z);
    };
    add_quad(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
    add_quad(corner(1, 0, 0), corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0));
    add_quad(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
    add_quad(corner(1, 0, 1), corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1));
    add_quad(corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0), corner(0, 1, 0));
    add_quad(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
  }

  /// An ellipsoid seen from outside, without what is less than `opening_rad` from its +Z axis.
  void add_ellipsoid(const Vec3& centre, const Vec3& radii, double opening_rad = 0.0) {
    add_surface(48, 24, [=](double u, double v) {
      const double from_axis = opening_rad + (pi - opening_rad) * (1.0 - v);
      const double around = 2.0 * pi * u;
      const Vec3 direction(std::sin(from_axis) * std::cos(around),
                           std::sin(from_axis) * std::sin(around), std::cos(from_axis));
      return centre + radii * direction;
    });
  }

  std::string obj() const {
    std::string text;
    for (const Vec3& corner : corners_) {
      text += fmt::format("v {} {} {}\n", corner.x, corner.y, corner.z);
    }
    for (std::size_t i = 1; i <= corners_.size(); i += 3) {
      text += fmt::format("f {} {} {}\n", i, i + 1, i + 2);
    }
    return text;
  }

  GlbBuilder glb() const {
    GlbBuilder glb;
    const int positions = glb.add_vectors(corners_);
    const int grey = glb.add(
        "materials", {{"pbrMetallicRoughness",
                       {{"baseColorFactor", {0.5, 0.5, 0.5, 1.0}}, {"metallicFactor", 0.0}}}});
    glb.add_root(
        {{"mesh", glb.add_mesh({{"attributes", {{"POSITION", positions}}}, {"material", grey}})}});
    return glb;
  }

 private:
  std::vector<Vec3> corners_;
};

/// A shell with an opening at its front, as of a helmet, and the same a little smaller within.
Triangles helmet() {
  Triangles shape;
  shape.add_ellipsoid({0, 1.7F, 0}, {0.12F, 0.15F, 0.15F}, 0.8);
  shape.add_ellipsoid({0, 1.7F, 0}, {0.11F, 0.14F, 0.14F}, 0.8);
  return shape;
}

Triangles head() {
  Triangles shape;
  shape.add_ellipsoid({0, 0, 0}, {0.8F, 1.0F, 0.9F});
  shape.add_ellipsoid({0, -0.1F, 0.9F}, {0.15F, 0.25F, 0.25F});
  shape.add_ellipsoid({-0.85F, 0, 0}, {0.1F, 0.3F, 0.2F});
  shape.add_ellipsoid({0.85F, 0, 0}, {0.1F, 0.3F, 0.2F});
  return shape;
}

void add_table(Triangles& shape, const Vec3& place) {
  shape.add_box(place + Vec3(-0.8F, 0.7F, -0.4F), place + Vec3(0.8F, 0.75F, 0.4F));
  for (const float x : {-0.75F, 0.7F}) {
    for (const float z : {-0.35F, 0.3F}) {
      shape.add_box(place + Vec3(x, 0.0F, z), place + Vec3(x + 0.05F, 0.7F, z + 0.05F));
    }
  }
}

/// Six metres by three by eight, its walls seen from within, with a table and a cupboard.
Triangles room(bool has_ceiling) {
  Triangles shape;
  const float height = 3.0F;
  shape.add_quad({-3, 0, 4}, {3, 0, 4}, {3, 0, -4}, {-3, 0, -4});
  shape.add_quad({-3, 0, -4}, {3, 0, -4}, {3, height, -4}, {-3, height, -4});
  shape.add_quad({3, 0, 4}, {-3, 0, 4}, {-3, height, 4}, {3, height, 4});
  shape.add_quad({-3, 0, 4}, {-3, 0, -4}, {-3, height, -4}, {-3, height, 4});
  shape.add_quad({3, 0, -4}, {3, 0, 4}, {3, height, 4}, {3, height, -4});
  if (has_ceiling) {
    shape.add_quad({-3, height, -4}, {3, height, -4}, {3, height, 4}, {-3, height, 4});
  }
  add_table(shape, {0, 0, 0});
  shape.add_box({-2.95F, 0, -3.5F}, {-2.3F, 2.0F, -1.5F});
  return shape;
}

Triangles terrain() {
  Triangles shape;
  shape.add_surface(64, 64, [](double u, double v) {
    const double hills = std::sin(7.0 * u + 1.0) * std::cos(5.0 * v) + 0.3 * std::sin(23.0 * v);
    return Vec3(200.0 * (u - 0.5), 6.0 * hills, 200.0 * (0.5 - v));
  });
  return shape;
}

Triangles table_top() {
  Triangles shape;
  shape.add_quad({-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2});
  shape.add_box({-1.2F, 0, -0.6F}, {-0.4F, 0.9F, 0.2F});
  shape.add_box({0.3F, 0, -0.9F}, {0.8F, 1.5F, -0.4F});
  shape.add_ellipsoid({0.8F, 0.35F, 0.6F}, Vec3(0.35F));
  return shape;
}

Triangles stool_in_millimetres() {
  Triangles shape;
  shape.add_box({-200, 420, -200}, {200, 450, 200});
  for (const float x : {-180.0F, 140.0F}) {
    for (const float z : {-180.0F, 140.0F}) {
      shape.add_box({x, 0, z}, {x + 40, 420, z + 40});
    }
  }
  return shape;
}

Triangles triangle() {
  Triangles shape;
  shape.add_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  return shape;
}

Triangles far_apart() {
  Triangles shape;
  shape.add_box({-501, 0, -1}, {-499, 2, 1});
  shape.add_box({499, 0, -1}, {501, 2, 1});
  return shape;
}

std::string with_lights(const Triangles& shape) {
  GlbBuilder glb = shape.glb();
  glb.document["extensionsUsed"] = {"KHR_lights_punctual"};
  Json& lights = glb.document["extensions"]["KHR_lights_punctual"]["lights"];
  lights = Json::array(
      {{{"type", "point"}, {"intensity", 20.0}}, {{"type", "directional"}, {"intensity", 1.0}}});
  glb.add_root({{"translation", {1.5, 2.5, 2.0}},
                {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  glb.add_root({{"rotation", {-0.5, 0.0, 0.0, std::sqrt(0.75)}},
                {"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
  return glb.bytes();
}

std::string with_camera(const Triangles& shape) {
  GlbBuilder glb = shape.glb();
  const int camera =
      glb.add("cameras", {{"type", "perspective"},
                          {"perspective", {{"yfov", 0.7}, {"znear", 0.1}, {"aspectRatio", 1.5}}}});
  glb.add_root({{"camera", camera}, {"translation", {0.0, 1.0, 5.0}}});
  return glb.bytes();
}

}  // namespace

std::vector<FirstLookFile> first_look_files() {
  const auto obj = [](const std::string& name, const std::function<Triangles()>& shape) {
    return FirstLookFile{
        .name = name, .file_name = name + ".obj", .content = [shape] { return shape().obj(); }};
  };
  std::vector<FirstLookFile> scenes = {obj("helmet", helmet),
                                       obj("head", head),
                                       obj("room", [] { return room(true); }),
                                       obj("room-without-a-ceiling", [] { return room(false); }),
                                       obj("terrain", terrain),
                                       obj("table-top", table_top),
                                       obj("triangle", triangle),
                                       obj("millimetres", stool_in_millimetres),
                                       obj("far-apart", far_apart)};
  scenes[2].most_covered = 1.0;
  scenes[2].is_enclosed = true;
  scenes[3].most_covered = 1.0;
  scenes[8].least_covered = 0.0;  // one of two metres in a kilometre
  scenes.push_back({.name = "lights-without-a-camera",
                    .file_name = "lights.glb",
                    .content = [] { return with_lights(table_top()); },
                    .has_light = true});
  scenes.push_back({.name = "a-camera-without-lights", .file_name = "camera.glb", .content = [] {
                      return with_camera(table_top());
                    }});
  scenes.push_back({.name = "empty",
                    .file_name = "empty.obj",
                    .content = [] { return std::string("# nothing\n"); },
                    .is_empty = true,
                    .least_covered = 0.0});
  return scenes;
}

}  // namespace foveola::test
