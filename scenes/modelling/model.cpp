#include "scenes/modelling/model.h"

#include <bit>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace foveola::scenes {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// A micrometre: finer than anything in the scenes, coarser than any difference between machines.
Vec3 rounded(const DVec3& position) {
  constexpr double steps_per_metre = 1 << 20;
  return {glm::round(position * steps_per_metre) / steps_per_metre};
}

/// A number's bits; both zeros have the same.
std::uint32_t bits(float x) { return std::bit_cast<std::uint32_t>(x + 0.0F); }

template <std::size_t word_count>
using Words = std::array<std::uint32_t, word_count>;

struct HashOfWords {
  template <std::size_t word_count>
  std::size_t operator()(const Words<word_count>& words) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t word : words) {
      hash = (hash ^ word) * 0x9e3779b97f4a7c15U;  // 2^64 by the golden ratio: spreads near words
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

/// Numbers things by value, in the order of their first occurrence.
template <typename Key>
class Numbering {
 public:
  explicit Numbering(std::size_t expected) { numbers_.reserve(expected); }

  /// The number of `value`, and whether it is new.
  std::pair<std::uint32_t, bool> number(const Key& value) {
    const auto [entry, is_new] =
        numbers_.try_emplace(value, static_cast<std::uint32_t>(numbers_.size()));
    return {entry->second, is_new};
  }

 private:
  std::unordered_map<Key, std::uint32_t, HashOfWords> numbers_;
};

/// A triangle's corners by position.
struct Face {
  Triangle points;
  Triangle corners;  ///< the same as indices into the shape
  DVec3 normal;      ///< unit length
  double doubled_area;
};

/// Faces over the rounded positions, without those that have no area.
struct Mesh {
  std::vector<Vec3> points;
  std::vector<Face> faces;
  std::vector<std::uint32_t> first_at_point;  ///< where a point's faces begin; one more at the end
  std::vector<std::uint32_t> faces_by_point;
};

/// Twice the area below which a triangle counts as degenerate, in square metres.
constexpr double least_doubled_area = 1e-10;

std::vector<std::uint32_t> weld_points(const Shape& shape, Mesh& mesh) {
  Numbering<Words<3>> numbering(shape.positions.size());
  std::vector<std::uint32_t> point_of_vertex;
  point_of_vertex.reserve(shape.positions.size());
  for (const DVec3& position : shape.positions) {
    const Vec3 point = rounded(position);
    const auto [number, is_new] = numbering.number({bits(point.x), bits(point.y), bits(point.z)});
    if (is_new) {
      mesh.points.push_back(point);
    }
    point_of_vertex.push_back(number);
  }
  return point_of_vertex;
}

/// Lists at each point the faces that meet there, in their order.
void join_faces(Mesh& mesh) {
  mesh.first_at_point.assign(mesh.points.size() + 1, 0);
  for (const Face& face : mesh.faces) {
    for (const std::uint32_t point : face.points) {
      ++mesh.first_at_point[point + 1];
    }
  }
  std::partial_sum(mesh.first_at_point.begin(), mesh.first_at_point.end(),
                   mesh.first_at_point.begin());
  mesh.faces_by_point.resize(mesh.first_at_point.back());
  std::vector<std::uint32_t> next = mesh.first_at_point;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    for (const std::uint32_t point : mesh.faces[i].points) {
      mesh.faces_by_point[next[point]++] = static_cast<std::uint32_t>(i);
    }
  }
}

Mesh weld(const Shape& shape) {
  Mesh mesh;
  const std::vector<std::uint32_t> point_of_vertex = weld_points(shape, mesh);
  mesh.faces.reserve(shape.triangles.size());
  for (const Triangle& corners : shape.triangles) {
    const Triangle points = {point_of_vertex[corners[0]], point_of_vertex[corners[1]],
                             point_of_vertex[corners[2]]};
    const DVec3 a(mesh.points[points[0]]);
    const DVec3 across =
        glm::cross(DVec3(mesh.points[points[1]]) - a, DVec3(mesh.points[points[2]]) - a);
    const double doubled_area = glm::length(across);
    if (doubled_area >= least_doubled_area) {
      mesh.faces.push_back({points, corners, across / doubled_area, doubled_area});
    }
  }
  join_faces(mesh);
  return mesh;
}

/// The mean, weighted by area, of the normals around a corner that bend from its face's own by less
/// than the crease angle.
Vec3 corner_normal(const Mesh& mesh, const Face& face, std::uint32_t point, double cos_crease) {
  DVec3 sum(0.0);
  for (std::uint32_t i = mesh.first_at_point[point]; i < mesh.first_at_point[point + 1]; ++i) {
    const Face& neighbour = mesh.faces[mesh.faces_by_point[i]];
    if (glm::dot(face.normal, neighbour.normal) >= cos_crease) {
      sum += neighbour.doubled_area * neighbour.normal;
    }
  }
  return {glm::normalize(sum)};
}

Surface finished(const Part& part, bool textured) {
  const Mesh mesh = weld(part.shape);
  const double cos_crease = std::cos(radians(part.crease_deg));
  Surface surface;
  surface.material = part.material;
  surface.triangles.reserve(mesh.faces.size());
  Numbering<Words<6>> numbering(part.shape.positions.size());
  for (const Face& face : mesh.faces) {
    Triangle triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t point = face.points[i];
      const Vec3 normal = corner_normal(mesh, face, point, cos_crease);
      const Vec2 uv = textured ? Vec2(part.shape.uvs[face.corners[i]]) : Vec2(0.0F);
      const auto [vertex, is_new] = numbering.number(
          {point, bits(normal.x), bits(normal.y), bits(normal.z), bits(uv.x), bits(uv.y)});
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
