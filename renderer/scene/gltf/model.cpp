#include "renderer/scene/gltf/model.h"

#include <utility>

namespace foveola {
namespace {

GltfBufferView view_of(const GltfValues& source) {
  return {.buffer = source.natural("buffer"),
          .offset = source.natural("byteOffset"),
          .length = source.natural("byteLength"),
          .stride = source.natural("byteStride")};
}

GltfComponent component_in(const GltfValues& source) {
  return static_cast<GltfComponent>(source.integer("componentType"));
}

std::optional<GltfAccessor::Sparse> sparse_of(const GltfValues& source) {
  if (!source.exists()) {
    return std::nullopt;
  }
  const GltfValues indices = source.object("indices");
  const GltfValues values = source.object("values");
  return GltfAccessor::Sparse{.count = source.natural("count"),
                              .index_view = indices.integer("bufferView"),
                              .index_offset = indices.natural("byteOffset"),
                              .index_component = component_in(indices),
                              .value_view = values.integer("bufferView"),
                              .value_offset = values.natural("byteOffset")};
}

GltfAccessor accessor_of(const GltfValues& source) {
  const std::string type = source.text("type");  // "SCALAR", "VEC3", "MAT4", ...
  const int side = type == "SCALAR" ? 1 : type.back() - '0';
  const bool is_matrix = type.starts_with("MAT");
  return {.view = source.integer("bufferView"),
          .offset = source.natural("byteOffset"),
          .count = source.natural("count"),
          .component = component_in(source),
          .components = is_matrix ? side * side : side,
          .is_matrix = is_matrix,
          .is_normalized = source.boolean("normalized", false),
          .sparse = sparse_of(source.object("sparse"))};
}

GltfPrimitive primitive_of(const GltfValues& source) {
  return {.attributes = source.indices("attributes"),
          .targets = source.list_of_indices("targets"),
          .indices = source.integer("indices"),
          .material = source.integer("material"),
          .mode = static_cast<GltfMode>(source.integer("mode", 4))};
}

GltfMesh mesh_of(const GltfValues& source) {
  GltfMesh mesh{.name = source.text("name"), .weights = source.numbers("weights")};
  for (std::size_t i = 0; i < source.size("primitives"); ++i) {
    mesh.primitives.push_back(primitive_of(source.item("primitives", i)));
  }
  return mesh;
}

GltfNode node_of(const GltfValues& source) {
  GltfNode node{.name = source.text("name"),
                .children = source.integers("children"),
                .mesh = source.integer("mesh"),
                .camera = source.integer("camera"),
                .skin = source.integer("skin"),
                .weights = source.numbers("weights"),
                .matrix = source.numbers("matrix")};
  if (node.matrix.empty()) {
    node.translation = source.numbers("translation");
    node.rotation = source.numbers("rotation");
    node.scale = source.numbers("scale");
  }
  if (const GltfValues extensions = source.object("extensions"); extensions.exists()) {
    node.light = extensions.object("KHR_lights_punctual").integer("light");
    node.is_visible = extensions.object("KHR_node_visibility").boolean("visible", true);
    node.instance_attributes = extensions.object("EXT_mesh_gpu_instancing").indices("attributes");
  }
  return node;
}

GltfImage image_of(const GltfValues& source) {
  return {.view = source.integer("bufferView"), .uri = source.text("uri")};
}

template <typename Item>
std::vector<Item> read_list(const GltfValues& root, const char* name,
                            Item (*read)(const GltfValues&)) {
  std::vector<Item> items;
  items.reserve(root.size(name));
  for (std::size_t i = 0; i < root.size(name); ++i) {
    items.push_back(read(root.item(name, i)));
  }
  return items;
}

}  // namespace

GltfModel::GltfModel(nlohmann::json checked)
    : document(std::move(checked)),
      views(read_list(root(), "bufferViews", view_of)),
      accessors(read_list(root(), "accessors", accessor_of)),
      meshes(read_list(root(), "meshes", mesh_of)),
      nodes(read_list(root(), "nodes", node_of)),
      images(read_list(root(), "images", image_of)) {}

}  // namespace foveola
