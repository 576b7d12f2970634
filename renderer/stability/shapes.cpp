#include "renderer/stability/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace foveola {
namespace {

using TriangleIndices = std::array<std::uint32_t, 3>;

/// Appends `mesh` unchanged: equal vertices are not merged.
void append(Mesh& to, const Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  to.positions.insert(to.positions.end(), mesh.positions.begin(), mesh.positions.end());
  for (const auto& [a, b, c] : mesh.triangles) {
    to.triangles.push_back({first + a, first + b, first + c});
  }
}

/// Turns the front faces of a convex mesh towards `center`, which lies inside.
void turn_fronts_inside(Mesh& mesh, const Vec3& center) {
  for (TriangleIndices& t : mesh.triangles) {
    const Vec3 normal = glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                   mesh.positions[t[2]] - mesh.positions[t[0]]);
    if (glm::dot(normal, mesh.positions[t[0]] - center) > 0.0F) {
      std::swap(t[1], t[2]);
    }
  }
}

/// Replaces each triangle by four. New vertices lie in the directions of the edges' midpoints, at
/// any length: the caller normalises them.
void subdivide(Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints;
  const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] =
        midpoints.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) {
      mesh.positions.push_back(glm::normalize(mesh.positions[a]) +
                               glm::normalize(mesh.positions[b]));
    }
    return found->second;
  };
  std::vector<TriangleIndices> finer;
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = midpoint(a, b);
    const std::uint32_t bc = midpoint(b, c);
    const std::uint32_t ca = midpoint(c, a);
    finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  mesh.triangles = std::move(finer);
}

}  // namespace

Mesh quad(const Vec3& corner, const Vec3& a, const Vec3& b, int material) {
  Mesh mesh;
  mesh.material = material;
  mesh.positions = {corner, corner + a, corner + a + b, corner + b};
  mesh.uv_sets = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Mesh tessellated_quad(const Vec3& corner, const Vec3& a, const Vec3& b, int cells, int material) {
  Mesh mesh;
  mesh.material = material;
  const auto columns = static_cast<std::uint32_t>(cells) + 1;
  for (int y = 0; y <= cells; ++y) {
    for (int x = 0; x <= cells; ++x) {
      const float u = static_cast<float>(x) / static_cast<float>(cells);
      const float v = static_cast<float>(y) / static_cast<float>(cells);
      mesh.positions.push_back(corner + u * a + v * b);
    }
  }
  for (std::uint32_t y = 0; y + 1 < columns; ++y) {
    for (std::uint32_t x = 0; x + 1 < columns; ++x) {
      const std::uint32_t i = y * columns + x;
      mesh.triangles.push_back({i, i + 1, i + 1 + columns});
      mesh.triangles.push_back({i, i + 1 + columns, i + columns});
    }
  }
  return mesh;
}

Mesh inward_box(const Vec3& center, float half, int material) {
  return tessellated_inward_box(center, half, 1, material);
}

Mesh tessellated_inward_box(const Vec3& center, float half, int cells, int material) {
  Mesh mesh;
  mesh.material = material;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0F, 1.0F}) {
      // From -1 to 1 in even steps: the same numbers on every side, so that edges meet to the bit.
      Mesh face = tessellated_quad(Vec3(-1, -1, side), Vec3(2, 0, 0), Vec3(0, 2, 0), cells, 0);
      for (Vec3& p : face.positions) {
        const Vec3 unit(p[(3 - axis) % 3], p[(4 - axis) % 3], p[(5 - axis) % 3]);
        p = center + half * unit;
      }
      append(mesh, face);
    }
  }
  turn_fronts_inside(mesh, center);
  return mesh;
}

Mesh inward_tetrahedron(float radius, int cells, int material) {
  Mesh mesh;
  mesh.material = material;
  const std::array<Vec3, 4> corners{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  const auto n = static_cast<float>(cells);
  for (std::size_t omitted = 0; omitted < 4; ++omitted) {
    const Vec3& a = corners[(omitted + 1) % 4];
    const Vec3& b = corners[(omitted + 2) % 4];
    const Vec3& c = corners[(omitted + 3) % 4];
    // Whole numbers up to n are exact, and so are their sums: edges meet to the bit.
    const auto at = [&](int i, int k) {
      const auto u = static_cast<float>(i);
      const auto v = static_cast<float>(k);
      return radius / std::sqrt(3.0F) / n * ((n - u - v) * a + u * b + v * c);
    };
    const auto add = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), {p, q, r});
      mesh.triangles.push_back({first, first + 1, first + 2});
    };
    for (int i = 0; i < cells; ++i) {
      for (int k = 0; i + k < cells; ++k) {
        add(at(i, k), at(i + 1, k), at(i, k + 1));
        if (i + k + 1 < cells) {
          add(at(i + 1, k), at(i + 1, k + 1), at(i, k + 1));
        }
      }
    }
  }
  turn_fronts_inside(mesh, Vec3(0.0F));
  return mesh;
}

Mesh inward_sphere(float radius, int level, int material) {
  const float g = 0.5F * (1.0F + std::sqrt(5.0F));
  Mesh mesh;
  mesh.material = material;
  mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 5, 11}, {0, 1, 5},  {0, 7, 1},   {0, 10, 7}, {0, 11, 10},
                    {1, 9, 5},  {5, 4, 11}, {11, 2, 10}, {10, 6, 7}, {7, 8, 1},
                    {3, 4, 9},  {3, 2, 4},  {3, 6, 2},   {3, 8, 6},  {3, 9, 8},
                    {4, 5, 9},  {2, 11, 4}, {6, 10, 2},  {8, 7, 6},  {9, 1, 8}};
  for (int i = 0; i < level; ++i) {
    subdivide(mesh);
  }
  for (Vec3& position : mesh.positions) {
    mesh.normals.push_back(-glm::normalize(position));
    position = radius * glm::normalize(position);
  }
  return mesh;
}

Mesh torus(float ring_radius, float tube_radius, int segments, int material) {
  Mesh mesh;
  mesh.material = material;
  const auto n = static_cast<std::uint32_t>(segments);
  const float step = 2.0F * std::numbers::pi_v<float> / static_cast<float>(segments);
  for (std::uint32_t i = 0; i < n; ++i) {
    const float turn = step * static_cast<float>(i);
    const Vec3 outwards(std::cos(turn), 0.0F, std::sin(turn));
    for (std::uint32_t k = 0; k < n; ++k) {
      const float roll = step * static_cast<float>(k);
      const Vec3 normal = std::cos(roll) * outwards + std::sin(roll) * Vec3(0, 1, 0);
      mesh.positions.push_back(ring_radius * outwards + tube_radius * normal);
      mesh.normals.push_back(normal);
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t i2 = (i + 1) % n;
      const std::uint32_t k2 = (k + 1) % n;
      mesh.triangles.push_back({i * n + k, i * n + k2, i2 * n + k2});
      mesh.triangles.push_back({i * n + k, i2 * n + k2, i2 * n + k});
    }
  }
  return mesh;
}

Mesh inside_out(Mesh mesh) {
  for (Vec3& normal : mesh.normals) {
    normal = -normal;
  }
  for (TriangleIndices& triangle : mesh.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

Mesh flat_shaded(Mesh mesh) {
  mesh.normals.clear();
  return mesh;
}

Mesh placed(Mesh mesh, float scale, const Quat& turn, const Vec3& place) {
  for (Vec3& position : mesh.positions) {
    position = turn * (scale * position) + place;
  }
  for (Vec3& normal : mesh.normals) {
    normal = turn * normal;
  }
  return mesh;
}

Material matte(const Rgb& albedo) {
  Material material;
  material.base_color = albedo;
  material.specular = 0.0F;
  return material;
}

Material dielectric(float albedo, float roughness) {
  Material material;
  material.base_color = Rgb(albedo);
  material.roughness = roughness;
  return material;
}

Material metal(float albedo, float roughness) {
  Material material = dielectric(albedo, roughness);
  material.metallic = 1.0F;
  return material;
}

Material glass(float roughness) {
  Material material = dielectric(1.0F, roughness);
  material.transmission = 1.0F;
  material.is_solid = true;
  return material;
}

Material lamp(const Rgb& radiance, bool double_sided) {
  Material material = matte(Rgb(0.0F));
  material.emission = radiance;
  material.double_sided = double_sided;
  return material;
}

Environment constant_environment(float radiance) {
  Environment environment;
  environment.radiance = Rgb(radiance);
  return environment;
}

}  // namespace foveola
