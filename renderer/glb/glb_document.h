// Writes binary glTF files, for stress tests and tests (glTF 2.0 specification, Khronos 2021,
// sections 3.6 and 4.4).
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

namespace foveola {

/// The bytes of a .glb file. json: the document's text. binary: the buffer; an empty one has no
/// chunk. Both are padded to whole words.
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

/// A document under construction, and its only buffer. JsonType: nlohmann::json, or
/// nlohmann::ordered_json to keep the order of members.
template <typename JsonType>
struct GlbDocument {
  using Json = JsonType;

  Json document;
  std::string buffer;

  /// Appends `item` to the array `list` of the document and returns its index.
  int add(const char* list, Json item);

  /// Adds a node, also to scene 0. Returns its index.
  int add_root(Json node);

  /// Appends `bytes` at a whole word and returns the index of their buffer view.
  int add_view(std::span<const std::byte> bytes, GlbTarget target = GlbTarget::none);

  /// The same, with an accessor of `count` elements that fill the view. Returns the accessor's
  /// index.
  int add_accessor(std::span<const std::byte> bytes, GlbComponent component, const char* type,
                   std::size_t count, GlbTarget target = GlbTarget::none);

  /// The file's bytes. Lists the buffer unless the document has a list already.
  std::string bytes() const;
};

}  // namespace foveola
