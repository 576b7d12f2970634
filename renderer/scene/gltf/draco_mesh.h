// Meshes that Draco compressed, from strangers: never decoded into more memory than was allowed
// beforehand. In a shared library of its own, for Debian's libdraco holds another version of
// tinygltf, which would take the place of the program's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#define FOVEOLA_DRACO_API __attribute__((visibility("default")))

namespace draco {
class Mesh;
}

namespace foveola {

struct DracoLimits {
  std::size_t most_points = 0;
  std::size_t most_triangles = 0;
  std::size_t most_bytes = 0;  ///< of all attributes while they are decoded, estimated
};

class FOVEOLA_DRACO_API DracoMesh {
 public:
  /// The mesh in `encoded`. Throws std::runtime_error that says what is wrong if it is none,
  /// damaged, in Draco's format before 2.2, which glTF does not allow, or beyond the limits.
  DracoMesh(std::span<const unsigned char> encoded, const DracoLimits& limits);
  ~DracoMesh();
  DracoMesh(const DracoMesh&) = delete;
  DracoMesh& operator=(const DracoMesh&) = delete;

  std::size_t points() const;
  std::size_t triangles() const;

  /// The points of each triangle, one triangle after the other.
  std::vector<std::uint32_t> indices() const;

  /// The values that the attribute of this unique id has in each point: `components` numbers, of
  /// the type that is `component_type` in glTF. Nothing if there is no such attribute.
  std::optional<std::vector<unsigned char>> values(std::uint32_t id, int components,
                                                   int component_type) const;

 private:
  std::unique_ptr<const draco::Mesh> mesh_;
};

}  // namespace foveola
