#include "renderer/scene/gltf_file/document.h"

#include "renderer/scene/gltf_file/fault.h"
#include "tests/matchers.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {
namespace {

/// "PLACE: WHAT" of the fault in `text`.
std::string fault_in_text(const std::string& text) {
  try {
    checked_gltf_document(text);
  } catch (const GltfFault& fault) {
    return fault.where() + ": " + fault.what();
  }
  ADD_FAILURE() << "no fault in " << text;
  return {};
}

std::string fault_in(const Json& document) { return fault_in_text(document.dump()); }

/// A document with one of everything that the loader reads.
Json complete() {
  return Json::parse(R"({
    "asset": {"version": "2.0", "minVersion": "2.0"},
    "scene": 0,
    "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "camera": 0, "children": [1], "translation": [1, 2, 3],
               "rotation": [0, 0, 0, 1], "scale": [1, 1, 1],
               "extensions": {"KHR_lights_punctual": {"light": 0}}},
              {"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 0, "material": 0,
                                "mode": 4}]}],
    "accessors": [{"bufferView": 0, "byteOffset": 0, "componentType": 5126, "count": 3,
                   "type": "VEC3", "normalized": false},
                  {"componentType": 5126, "count": 3, "type": "VEC3",
                   "sparse": {"count": 1,
                              "indices": {"bufferView": 0, "byteOffset": 0, "componentType": 5123},
                              "values": {"bufferView": 0, "byteOffset": 4}}}],
    "bufferViews": [{"buffer": 0, "byteOffset": 4, "byteLength": 36, "byteStride": 12}],
    "buffers": [{"byteLength": 40}],
    "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1],
                                            "baseColorTexture": {"index": 0, "texCoord": 1},
                                            "metallicFactor": 0.5, "roughnessFactor": 1,
                                            "metallicRoughnessTexture": {"index": 0}},
                   "emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0},
                   "normalTexture": {"index": 0, "scale": 0.5}, "alphaMode": "MASK",
                   "alphaCutoff": 0.5, "doubleSided": true,
                   "extensions": {
                     "KHR_materials_emissive_strength": {"emissiveStrength": 5},
                     "KHR_materials_ior": {"ior": 1.33},
                     "KHR_materials_specular": {"specularFactor": 1, "specularTexture": {"index": 0},
                                                "specularColorFactor": [1, 1, 1],
                                                "specularColorTexture": {"index": 0}},
                     "KHR_materials_transmission": {"transmissionFactor": 1,
                                                    "transmissionTexture": {"index": 0}},
                     "KHR_materials_volume": {"thicknessFactor": 1, "attenuationDistance": 0.5,
                                              "attenuationColor": [1, 1, 1]},
                     "KHR_materials_clearcoat": {"clearcoatFactor": 1,
                                                 "clearcoatTexture": {"index": 0},
                                                 "clearcoatRoughnessFactor": 1,
                                                 "clearcoatRoughnessTexture": {"index": 0}},
                     "KHR_materials_sheen": {"sheenColorFactor": [1, 1, 1],
                                             "sheenColorTexture": {"index": 0, "extensions": {
                                               "KHR_texture_transform": {"offset": [0, 0.5],
                                                 "rotation": 1, "scale": [1, 1], "texCoord": 1}}},
                                             "sheenRoughnessFactor": 1,
                                             "sheenRoughnessTexture": {"index": 0}},
                     "KHR_materials_unlit": {}}}],
    "textures": [{"source": 0, "sampler": 0}],
    "samplers": [{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728, "minFilter": 9987}],
    "images": [{"bufferView": 0}],
    "cameras": [{"type": "perspective"}],
    "extensions": {"KHR_lights_punctual": {"lights": [
      {"name": "lamp", "type": "spot", "color": [1, 1, 1], "intensity": 5, "range": 3,
       "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}}]}},
    "extensionsUsed": ["KHR_materials_emissive_strength", "KHR_materials_ior"],
    "extensionsRequired": ["KHR_materials_emissive_strength"]
  })");
}

TEST(GltfDocument, AcceptsACompleteOne) {
  EXPECT_NO_THROW(checked_gltf_document(complete().dump()));
}

/// Each value that the loader reads, replaced by one that it may not have.
TEST(GltfDocument, NamesThePlaceOfEveryWrongValue) {
  struct Wrong {
    const char* pointer;
    Json value;
    const char* fault;
  };
  const std::vector<Wrong> cases = {
      {"/asset", "2.0", "asset: must be an object"},
      {"/asset/version", 2.0, "asset.version: must be a text"},
      {"/asset/version", "1.0", "asset.version: is 1.0, but only glTF 2"},
      {"/asset/version", 1.0, "asset.version: is 1.0, but only glTF 2"},
      {"/asset/minVersion", "2.1", "asset.minVersion: demands a newer glTF"},
      {"/scene", 1, "scene: is 1, but scenes has 1 elements"},
      {"/scenes/0/nodes/0", 2, "scenes[0].nodes[0]: is 2, but nodes has 2 elements"},
      {"/extensionsUsed", "KHR_materials_ior", "extensionsUsed: must be an array"},
      {"/nodes/1", 7, "nodes[1]: must be an object"},
      {"/nodes/0/children/0", -1, "nodes[0].children[0]: is -1, but nodes has 2"},
      {"/nodes/0/mesh", "cube", "nodes[0].mesh: must be an index into meshes"},
      {"/nodes/0/camera", 0.5, "nodes[0].camera: must be an index into cameras"},
      {"/nodes/0/camera", 1.0, "nodes[0].camera: is 1, but cameras has 1 elements"},
      {"/nodes/0/camera", -0.0, "nodes[0].camera: must be an index into cameras"},
      {"/nodes/0/translation", {1, 2}, "nodes[0].translation: must be 3 numbers"},
      {"/nodes/0/rotation", {1, 2, 3, "w"}, "nodes[0].rotation: must be 4 numbers"},
      {"/nodes/0/scale", 2, "nodes[0].scale: must be 3 numbers"},
      {"/nodes/1/matrix", Json::array(), "nodes[1].matrix: must be 16 numbers"},
      {"/meshes/0/primitives", Json::array(), "meshes[0].primitives: must have 1 or more"},
      {"/meshes/0/primitives/0/attributes", {0}, "meshes[0].primitives[0].attributes: must be an"},
      {"/meshes/0/primitives/0/attributes/POSITION", 2,
       "meshes[0].primitives[0].attributes.POSITION: is 2, but accessors has 2 elements"},
      {"/meshes/0/primitives/0/indices", 4294967296,
       "meshes[0].primitives[0].indices: is 4294967296"},
      {"/meshes/0/primitives/0/material", 9, "meshes[0].primitives[0].material: is 9"},
      {"/meshes/0/primitives/0/mode", 7, "meshes[0].primitives[0].mode: must be an integer from"},
      {"/accessors/0/bufferView", 1, "accessors[0].bufferView: is 1, but bufferViews has 1"},
      {"/accessors/0/byteOffset", -4, "accessors[0].byteOffset: must be an integer from 0"},
      {"/accessors/0/componentType", 5124, "accessors[0].componentType: must be one of 5120"},
      {"/accessors/0/count", 0, "accessors[0].count: must be an integer from 1"},
      {"/accessors/0/count", 18446744073709551615U,
       "accessors[0].count: must be an integer from 1"},
      {"/accessors/0/count", 1e18, "accessors[0].count: must be an integer from 1"},
      {"/accessors/0/type", "VEC5", "accessors[0].type: must be one of SCALAR"},
      {"/accessors/0/normalized", 1, "accessors[0].normalized: must be true or false"},
      {"/bufferViews/0/buffer", 1, "bufferViews[0].buffer: is 1, but buffers has 1 elements"},
      {"/bufferViews/0/byteLength", 37, "bufferViews[0]: ends at byte 41, but buffers[0] has 40"},
      {"/bufferViews/0/byteOffset", 4294967295U, "bufferViews[0]: ends at byte 4294967331"},
      {"/bufferViews/0/byteStride", 3, "bufferViews[0].byteStride: must be an integer from 4"},
      {"/bufferViews/0/byteStride", 14, "bufferViews[0].byteStride: must be a multiple of 4"},
      {"/buffers/0/byteLength", 0, "buffers[0].byteLength: must be an integer from 1"},
      {"/buffers/0/uri", 5, "buffers[0].uri: must be a text"},
      {"/materials/0/pbrMetallicRoughness/baseColorFactor",
       {1, 1, 1},
       "materials[0].pbrMetallicRoughness.baseColorFactor: must be 4 numbers"},
      {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", 1,
       "materials[0].pbrMetallicRoughness.baseColorTexture.index: is 1, but textures has 1"},
      {"/materials/0/pbrMetallicRoughness/metallicFactor", "metal",
       "materials[0].pbrMetallicRoughness.metallicFactor: must be a number"},
      {"/materials/0/emissiveTexture/texCoord", -1,
       "materials[0].emissiveTexture.texCoord: must be"},
      {"/materials/0/emissiveFactor", {1}, "materials[0].emissiveFactor: must be 3 numbers"},
      {"/materials/0/alphaMode", "mask", "materials[0].alphaMode: must be one of OPAQUE"},
      {"/materials/0/alphaCutoff", -0.5, "materials[0].alphaCutoff: must be a number from 0"},
      {"/materials/0/doubleSided", "yes", "materials[0].doubleSided: must be true or false"},
      {"/materials/0/normalTexture/scale", "steep", "materials[0].normalTexture.scale: must be a"},
      {"/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength",
       {1},
       "materials[0].extensions.KHR_materials_emissive_strength.emissiveStrength: must be a "
       "number"},
      {"/materials/0/extensions/KHR_materials_ior/ior", "glass",
       "materials[0].extensions.KHR_materials_ior.ior: must be a number from"},
      {"/materials/0/extensions/KHR_materials_unlit", 1,
       "materials[0].extensions.KHR_materials_unlit: must be an object"},
      {"/materials/0/extensions/KHR_materials_volume/attenuationColor",
       {1, 1, "blue"},
       "materials[0].extensions.KHR_materials_volume.attenuationColor: must be 3 numbers"},
      {"/materials/0/extensions/KHR_materials_sheen/sheenColorTexture/index", 1,
       "materials[0].extensions.KHR_materials_sheen.sheenColorTexture.index: is 1, but textures"},
      {"/materials/0/extensions/KHR_materials_sheen/sheenColorTexture/extensions/"
       "KHR_texture_transform/scale",
       2,
       "materials[0].extensions.KHR_materials_sheen.sheenColorTexture.extensions."
       "KHR_texture_transform.scale: must be 2 numbers"},
      {"/materials/0/extensions/KHR_materials_sheen/sheenColorTexture/extensions/"
       "KHR_texture_transform/texCoord",
       -1,
       "materials[0].extensions.KHR_materials_sheen.sheenColorTexture.extensions."
       "KHR_texture_transform.texCoord: must be an integer"},
      {"/accessors/1/sparse/count", 4, "accessors[1].sparse.count: is larger than the accessor's"},
      {"/accessors/1/sparse/count", 0, "accessors[1].sparse.count: must be an integer from 1"},
      {"/accessors/1/sparse/indices/bufferView", 1,
       "accessors[1].sparse.indices.bufferView: is 1, but bufferViews has 1"},
      {"/accessors/1/sparse/indices/componentType", 5126,
       "accessors[1].sparse.indices.componentType: must be one of 5121"},
      {"/accessors/1/sparse/values/byteOffset", 4294967296,
       "accessors[1].sparse.values.byteOffset: must be an integer from 0"},
      {"/nodes/0/extensions/KHR_lights_punctual/light", 1,
       "nodes[0].extensions.KHR_lights_punctual.light: is 1, but lights has 1 elements"},
      {"/extensions/KHR_lights_punctual/lights/0/type", 1,
       "extensions.KHR_lights_punctual.lights[0].type: must be a text"},
      {"/extensions/KHR_lights_punctual/lights/0/color",
       {1, 1},
       "extensions.KHR_lights_punctual.lights[0].color: must be 3 numbers"},
      {"/extensions/KHR_lights_punctual/lights", 7,
       "nodes[0].extensions.KHR_lights_punctual.light: is 0, but lights has 0 elements"},
      {"/samplers/0/minFilter", 9990, "samplers[0].minFilter: must be one of 9728"},
      {"/textures/0/source", 1, "textures[0].source: is 1, but images has 1 elements"},
      {"/textures/0/sampler", 1, "textures[0].sampler: is 1, but samplers has 1 elements"},
      {"/samplers/0/wrapS", 1, "samplers[0].wrapS: must be one of 33071"},
      {"/images/0/bufferView", 1, "images[0].bufferView: is 1, but bufferViews has 1 elements"},
      {"/images/0/uri", "a.png", "images[0]: must have either a uri or a bufferView"},
      {"/cameras/0/type", "fisheye", "cameras[0].type: must be one of perspective"},
      {"/cameras/0/perspective", Json::object({{"yfov", "wide"}}),
       "cameras[0].perspective.yfov: must be a number"},
      {"/extensionsUsed/0", 3, "extensionsUsed[0]: must be a text"},
      {"/extensionsRequired/0", "EXT_mesh_manifold",
       "extensionsRequired[0]: the extension EXT_mesh_manifold is not supported"},
      // Compressed textures have no fallback where the extension is required.
      {"/extensionsRequired/0", "KHR_texture_basisu",
       "extensionsRequired[0]: the extension KHR_texture_basisu is not supported"}};
  for (const Wrong& wrong : cases) {
    Json document = complete();
    document[Json::json_pointer(wrong.pointer)] = wrong.value;
    EXPECT_THAT(fault_in(document), StartsWith(wrong.fault));
  }
}

TEST(GltfDocument, NamesWhatIsMissing) {
  for (const char* pointer :
       {"/asset/version", "/meshes/0/primitives", "/buffers/0/byteLength", "/bufferViews/0/buffer",
        "/accessors/0/componentType", "/accessors/0/count", "/accessors/0/type", "/cameras/0/type",
        "/materials/0/emissiveTexture/index", "/accessors/1/sparse/indices",
        "/accessors/1/sparse/values/bufferView",
        "/materials/0/extensions/KHR_materials_clearcoat/clearcoatTexture/index",
        "/nodes/0/extensions/KHR_lights_punctual/light",
        "/extensions/KHR_lights_punctual/lights/0/type",
        "/extensions/KHR_lights_punctual/lights/0/spot"}) {
    const Json::json_pointer missing(pointer);
    Json document = complete();
    document[missing.parent_pointer()].erase(missing.back());
    EXPECT_THAT(fault_in(document), HasSubstr(missing.back() + ": is missing")) << pointer;
  }
  EXPECT_EQ(fault_in(Json::object()), "asset: is missing");
}

TEST(GltfDocument, RefusesWhatIsNoJson) {
  EXPECT_EQ(fault_in_text(""), "line 1, column 1: this is not JSON");
  EXPECT_EQ(fault_in_text("# Blender\nmtllib a.mtl"), "line 1, column 1: this is not JSON");
  EXPECT_THAT(fault_in_text("{\n  \"asset\": {,\n"), StartsWith("line 2, column 13: "));
  EXPECT_THAT(fault_in_text("[1, 2]"), HasSubstr("must be an object"));
  EXPECT_THAT(fault_in_text(R"({"asset": {"version": "2.0"}, "extras": 1e999})"),
              HasSubstr("number that is too large"));
  EXPECT_THAT(fault_in_text("{\"asset\": \"\xff\xfe\"}"), HasSubstr("this is not JSON"));
}

/// Descending into it could overflow the stack.
TEST(GltfDocument, RefusesBottomlessNesting) {
  const auto extras = [](std::size_t depth) {
    return R"({"asset": {"version": "2.0"}, "extras": )" + std::string(depth, '[') +
           std::string(depth, ']') + "}";
  };
  EXPECT_NO_THROW(checked_gltf_document(extras(63)));
  EXPECT_THAT(fault_in_text(extras(64)), HasSubstr("nested more than 64 deep"));
  EXPECT_THAT(fault_in_text(extras(1000000)), HasSubstr("nested more than 64 deep"));
}

TEST(GltfDocument, BracketsInTextsAreNotNesting) {
  const std::string text = R"("\"[)" + std::string(1000, '{') + R"(\\")";
  EXPECT_NO_THROW(
      checked_gltf_document(R"({"asset": {"version": "2.0"}, "extras": )" + text + "}"));
}

void write_with_points(Json& value) {
  if (value.is_structured()) {
    for (Json& element : value) {
      write_with_points(element);
    }
  } else if (value.is_number()) {
    value = value.get<double>();
  }
}

/// Some programs know only one kind of number.
TEST_F(LoadGltf, WholeNumbersMayBeWrittenWithAPoint) {
  GlbBuilder glb = textured_triangle("triangle.bin", "a.png");
  write("triangle.bin", glb.buffer);
  write("a.png", one_pixel(1, 2, 3));
  write_with_points(glb.document);
  EXPECT_THAT(glb.document.dump(), HasSubstr("\"componentType\":5126.0"));
  const Scene scene = load_bytes(glb.document.dump(), "scene.gltf");
  EXPECT_EQ(scene.triangle_count(), 1U);
  EXPECT_EQ(scene.textures.size(), 1U);
  EXPECT_THAT(scene.warnings, IsEmpty());
}

}  // namespace
}  // namespace foveola::test
