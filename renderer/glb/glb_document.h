// Writes binary glTF files: the one place that knows their container, for stress tests
// and tests alike (glTF 2.0 specification, Khronos 2021, sections 3.6 and 4.4).
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

namespace foveola {

/// The bytes of a .glb file. json: the document's text. binary: the buffer; there is no chunk for
/// an empty one. Both are padded to whole words.
std::string glb_container(std::string json, std::string binary);

/// componentType of an accessor.
enum class GlbComponent : int {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};

/// target of a buffer view.
enum class GlbTarget : int { none = 0, vertices = 34962, indices = 34963 };

/// A document under construction, and the bytes of its only buffer. JsonType: nlohmann::json, or
/// nlohmann::ordered_json for members in the order in which they were added.
template <typename JsonType>
struct GlbDocument {
  using Json = JsonType;

  Json document;
  std::string buffer;

  /// Appends `item` to the array `list` of the document and returns its index.
  int add(const char* list, Json item);

  /// A node, which is also listed in scene 0. Returns its index.
  int add_root(Json node);

  /// Appends `bytes` at a whole word and returns the index of a buffer view of exactly them.
  int add_view(std::span<const std::byte> bytes, GlbTarget target = GlbTarget::none);

  /// The same, and an accessor of `count` elements that fill the view. Returns the accessor's
  /// index.
  int add_accessor(std::span<const std::byte> bytes, GlbComponent component, const char* type,
                   std::size_t count, GlbTarget target = GlbTarget::none);

  /// The file. It lists the buffer unless the document lists buffers already.
  std::string bytes() const;
};

}  // namespace foveola
