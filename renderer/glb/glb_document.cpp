#include "renderer/glb/glb_document.h"

#include <bit>
#include <cstdint>
#include <utility>

namespace foveola {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF's numbers are little-endian");

void pad(std::string& chunk, char filler) { chunk.resize((chunk.size() + 3) / 4 * 4, filler); }

std::string word(std::size_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  return {reinterpret_cast<const char*>(&bits), sizeof(bits)};
}

std::string chunk_of(const std::string& type, const std::string& content) {
  return word(content.size()) + type + content;
}

}  // namespace

std::string glb_container(std::string json, std::string binary) {
  constexpr std::size_t header_size = 12;
  pad(json, ' ');
  pad(binary, '\0');
  std::string chunks = chunk_of("JSON", json);
  if (!binary.empty()) {
    chunks += chunk_of(std::string("BIN\0", 4), binary);
  }
  return "glTF" + word(2) + word(header_size + chunks.size()) + chunks;
}

template <typename Json>
int GlbDocument<Json>::add(const char* list, Json item) {
  Json& items = document[list];
  items.push_back(std::move(item));
  return static_cast<int>(items.size()) - 1;
}

template <typename Json>
int GlbDocument<Json>::add_root(Json node) {
  const int index = add("nodes", std::move(node));
  document["scenes"][0]["nodes"].push_back(index);
  return index;
}

template <typename Json>
int GlbDocument<Json>::add_view(std::span<const std::byte> bytes, GlbTarget target) {
  pad(buffer, '\0');
  Json view = {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}};
  if (target != GlbTarget::none) {
    view["target"] = static_cast<int>(target);
  }
  buffer.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return add("bufferViews", std::move(view));
}

template <typename Json>
int GlbDocument<Json>::add_accessor(std::span<const std::byte> bytes, GlbComponent component,
                                    const char* type, std::size_t count, GlbTarget target) {
  const int view = add_view(bytes, target);
  return add("accessors", {{"bufferView", view},
                           {"componentType", static_cast<int>(component)},
                           {"count", count},
                           {"type", type}});
}

template <typename Json>
std::string GlbDocument<Json>::bytes() const {
  Json complete = document;
  std::string padded = buffer;
  pad(padded, '\0');
  if (!padded.empty() && !complete.contains("buffers")) {
    complete["buffers"] = Json::array({{{"byteLength", padded.size()}}});
  }
  return glb_container(complete.dump(), std::move(padded));
}

template struct GlbDocument<nlohmann::json>;
template struct GlbDocument<nlohmann::ordered_json>;

}  // namespace foveola
