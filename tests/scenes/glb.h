// A .glb file taken apart for tests, by the specification and not by the writer.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace foveola::scenes {

struct Glb {
  std::uint32_t magic = 0;
  std::uint32_t version = 0;
  std::uint32_t length = 0;
  std::uint32_t json_length = 0;
  std::uint32_t json_type = 0;
  std::uint32_t binary_length = 0;
  std::uint32_t binary_type = 0;
  nlohmann::json json;
  std::string binary;
};

inline std::uint32_t uint32_at(const std::string& file, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, file.substr(offset, 4).data(), 4);
  return value;
}

inline Glb taken_apart(const std::string& file) {
  Glb glb;
  glb.magic = uint32_at(file, 0);
  glb.version = uint32_at(file, 4);
  glb.length = uint32_at(file, 8);
  glb.json_length = uint32_at(file, 12);
  glb.json_type = uint32_at(file, 16);
  glb.json = nlohmann::json::parse(file.substr(20, glb.json_length));
  glb.binary_length = uint32_at(file, 20 + glb.json_length);
  glb.binary_type = uint32_at(file, 24 + glb.json_length);
  glb.binary = file.substr(28 + glb.json_length);
  return glb;
}

/// The items of a tightly packed accessor.
template <typename Item>
std::vector<Item> items_of(const Glb& glb, std::size_t accessor, std::size_t items_per_count = 1) {
  const nlohmann::json& a = glb.json.at("accessors").at(accessor);
  const nlohmann::json& view = glb.json.at("bufferViews").at(a.at("bufferView").get<std::size_t>());
  std::vector<Item> items(a.at("count").get<std::size_t>() * items_per_count);
  const std::size_t bytes = items.size() * sizeof(Item);
  if (view.at("byteLength").get<std::size_t>() != bytes) {
    throw std::runtime_error("an accessor does not fill its buffer view");
  }
  std::memcpy(items.data(),
              glb.binary.substr(view.at("byteOffset").get<std::size_t>(), bytes).data(), bytes);
  return items;
}

/// A primitive's indices, whichever of the two types they are in.
inline std::vector<std::uint32_t> indices_of(const Glb& glb, std::size_t accessor) {
  constexpr int uint16_type = 5123;
  if (glb.json.at("accessors").at(accessor).at("componentType") == uint16_type) {
    const auto indices = items_of<std::uint16_t>(glb, accessor);
    return {indices.begin(), indices.end()};
  }
  return items_of<std::uint32_t>(glb, accessor);
}

}  // namespace foveola::scenes
