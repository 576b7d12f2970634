#include "tests/renderer/scene/gltf_mesh/draco_square.h"

#include <array>
#include <cstdint>
#include <stdexcept>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>

namespace foveola::test {
namespace {

struct Corner {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
};

constexpr std::array<std::array<Corner, 3>, 2> triangles = {
    {{Corner{}, Corner{.x = 1.0F}, Corner{.x = 1.0F, .y = 1.0F}},
     {Corner{}, Corner{.x = 1.0F, .y = 1.0F}, Corner{.y = 1.0F}}}};

}  // namespace

std::string draco_square(DracoMethod method) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(triangles.size());
  const int position =
      builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(i), &a, &b, &c);
    builder.SetAttributeValuesForFace(uv, draco::FaceIndex(i), &a, &b, &c);
  }
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method == DracoMethod::sequential ? draco::MESH_SEQUENTIAL_ENCODING
                                                              : draco::MESH_EDGEBREAKER_ENCODING);
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeMeshToBuffer(*builder.Finalize(), &buffer).ok()) {
    throw std::runtime_error("the square cannot be encoded");
  }
  return {buffer.data(), buffer.size()};
}

}  // namespace foveola::test
