#include "renderer/scene/gltf/node_list.h"

#include <string>
#include <utility>

#include <nlohmann/json.hpp>

namespace foveola {
namespace {

using Json = nlohmann::json;

/// What stands under `key`, or `absent`.
template <typename Value>
Value value_in(const Json& node, const char* key, Value absent) {
  const auto found = node.find(key);
  return found != node.end() ? found->get<Value>() : std::move(absent);
}

std::vector<double> numbers_in(const Json& node, const char* key) {
  return value_in(node, key, std::vector<double>());
}

tinygltf::Value value_of(const Json& json) {
  switch (json.type()) {
    case Json::value_t::boolean:
      return tinygltf::Value(json.get<bool>());
    case Json::value_t::number_integer:
    case Json::value_t::number_unsigned:
      return tinygltf::Value(json.get<int>());
    case Json::value_t::number_float:
      return tinygltf::Value(json.get<double>());
    case Json::value_t::string:
      return tinygltf::Value(json.get<std::string>());
    case Json::value_t::array: {
      tinygltf::Value::Array elements;
      for (const Json& element : json) {
        elements.push_back(value_of(element));
      }
      return tinygltf::Value(std::move(elements));
    }
    case Json::value_t::object: {
      tinygltf::Value::Object members;
      for (const auto& [key, member] : json.items()) {
        members.emplace(key, value_of(member));
      }
      return tinygltf::Value(std::move(members));
    }
    default:
      return {};
  }
}

tinygltf::Node node_of(const Json& json) {
  tinygltf::Node node;
  node.name = value_in(json, "name", std::string());
  node.children = value_in(json, "children", std::vector<int>());
  node.mesh = value_in(json, "mesh", -1);
  node.camera = value_in(json, "camera", -1);
  node.skin = value_in(json, "skin", -1);
  node.weights = numbers_in(json, "weights");
  node.matrix = numbers_in(json, "matrix");
  if (node.matrix.empty()) {
    node.translation = numbers_in(json, "translation");
    node.rotation = numbers_in(json, "rotation");
    node.scale = numbers_in(json, "scale");
  }
  if (const auto extensions = json.find("extensions"); extensions != json.end()) {
    for (const auto& [name, extension] : extensions->items()) {
      node.extensions.emplace(name, value_of(extension));
    }
  }
  return node;
}

}  // namespace

std::vector<tinygltf::Node> node_list_of(const Json& nodes) {
  std::vector<tinygltf::Node> list;
  list.reserve(nodes.size());
  for (const Json& node : nodes) {
    list.push_back(node_of(node));
  }
  return list;
}

}  // namespace foveola
