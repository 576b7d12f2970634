#include "scenes/modelling/model.h"

#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace foveola::scenes {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// A micrometre: finer than anything in the scenes, coarser than any difference between machines.
Vec3 rounded(const DVec3& position) {
  constexpr double steps_per_metre = 1 << 20;
  return {glm::round(position * steps_per_metre) / steps_per_metre};
}

std::tuple<float, float, float> key(const Vec3& v) { return {v.x, v.y, v.z}; }

/// Numbers things by value, in the order of their first occurrence.
template <typename Key>
class Numbering {
 public:
  /// The number of `value`, and whether it is new.
  std::pair<std::uint32_t, bool> number(const Key& value) {
    const auto [entry, is_new] =
        numbers_.emplace(value, static_cast<std::uint32_t>(numbers_.size()));
    return {entry->second, is_new};
  }
  std::size_t size() const { return numbers_.size(); }

 private:
  std::map<Key, std::uint32_t> numbers_;
};

/// A triangle's corners by position, with its normal as long as twice its area.
struct Face {
  Triangle points;
  Triangle corners;  ///< the same as indices into the shape
  DVec3 normal;
};

/// Faces over the rounded positions, without those that have no area.
struct Mesh {
  std::vector<Vec3> points;
  std::vector<Face> faces;
  std::vector<std::vector<std::uint32_t>> faces_at_point;
};

/// Twice the area below which a triangle counts as degenerate, in square metres.
constexpr double least_doubled_area = 1e-10;

Mesh weld(const Shape& shape) {
  Mesh mesh;
  Numbering<std::tuple<float, float, float>> numbering;
  std::vector<std::uint32_t> point_of_vertex;
  point_of_vertex.reserve(shape.positions.size());
  for (const DVec3& position : shape.positions) {
    const Vec3 point = rounded(position);
    const auto [number, is_new] = numbering.number(key(point));
    if (is_new) {
      mesh.points.push_back(point);
    }
    point_of_vertex.push_back(number);
  }
  mesh.faces_at_point.resize(mesh.points.size());
  for (const Triangle& corners : shape.triangles) {
    const Triangle points = {point_of_vertex[corners[0]], point_of_vertex[corners[1]],
                             point_of_vertex[corners[2]]};
    const DVec3 a(mesh.points[points[0]]);
    const DVec3 normal =
        glm::cross(DVec3(mesh.points[points[1]]) - a, DVec3(mesh.points[points[2]]) - a);
    if (glm::length(normal) < least_doubled_area) {
      continue;
    }
    for (const std::uint32_t point : points) {
      mesh.faces_at_point[point].push_back(static_cast<std::uint32_t>(mesh.faces.size()));
    }
    mesh.faces.push_back({points, corners, normal});
  }
  return mesh;
}

/// The mean, weighted by area, of the normals around a corner that bend from its face's own by less
/// than the crease angle.
Vec3 corner_normal(const Mesh& mesh, const Face& face, std::uint32_t point, double cos_crease) {
  const DVec3 own = glm::normalize(face.normal);
  DVec3 sum(0.0);
  for (const std::uint32_t neighbour : mesh.faces_at_point[point]) {
    const DVec3& normal = mesh.faces[neighbour].normal;
    if (glm::dot(own, normal) >= cos_crease * glm::length(normal)) {
      sum += normal;
    }
  }
  return {glm::normalize(sum)};
}

Surface finished(const Part& part, bool textured) {
  const Mesh mesh = weld(part.shape);
  const double cos_crease = std::cos(radians(part.crease_deg));
  Surface surface;
  surface.material = part.material;
  Numbering<std::tuple<std::uint32_t, std::tuple<float, float, float>, float, float>> numbering;
  for (const Face& face : mesh.faces) {
    Triangle triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t point = face.points[i];
      const Vec3 normal = corner_normal(mesh, face, point, cos_crease);
      const Vec2 uv = textured ? Vec2(part.shape.uvs[face.corners[i]]) : Vec2(0.0F);
      const auto [vertex, is_new] = numbering.number({point, key(normal), uv.x, uv.y});
      if (is_new) {
        surface.positions.push_back(mesh.points[point]);
        surface.normals.push_back(normal);
        if (textured) {
          surface.uvs.push_back(uv);
        }
      }
      triangle[i] = vertex;
    }
    surface.triangles.push_back(triangle);
  }
  return surface;
}

template <typename T>
int add(std::vector<T>& items, T item) {
  items.push_back(std::move(item));
  return static_cast<int>(items.size()) - 1;
}

}  // namespace

std::size_t Model::triangle_count() const {
  std::size_t count = 0;
  for (const Object& object : objects) {
    for (const Surface& surface : object.surfaces) {
      count += surface.triangles.size();
    }
  }
  return count;
}

int add_image(Model& model, Image image) { return add(model.images, std::move(image)); }

int add_material(Model& model, Material material) {
  return add(model.materials, std::move(material));
}

int add_textured_material(Model& model, const char* name, Image image, float roughness) {
  const int image_index = add_image(model, std::move(image));
  return add_material(model, {.name = name,
                              .base_color = Rgb(1.0F),
                              .roughness = roughness,
                              .base_color_image = image_index});
}

void add_object(Model& model, std::string name, const std::vector<Part>& parts) {
  Object object{std::move(name), {}};
  for (const Part& part : parts) {
    const bool textured = model.materials.at(part.material).base_color_image >= 0;
    Surface surface = finished(part, textured);
    if (!surface.triangles.empty()) {
      object.surfaces.push_back(std::move(surface));
    }
  }
  model.objects.push_back(std::move(object));
}

}  // namespace foveola::scenes
