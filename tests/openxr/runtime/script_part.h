// Reading an object of the script by its keys.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace foveola::test::openxr {

/// An object, with where it is in the file for messages. Throws std::runtime_error for a key that
/// it must not have, since a mistyped key would be a test of nothing, and for values of the wrong
/// kind.
class ScriptPart {
 public:
  ScriptPart(const nlohmann::json& object, std::string where,
             std::initializer_list<const char*> keys)
      : object_(object), where_(std::move(where)) {
    if (!object_.is_object()) {
      fail("is not an object");
    }
    for (const auto& [key, value] : object_.items()) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
        fail(fmt::format("has a key '{}', which means nothing", key));
      }
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(fmt::format("the script: {} {}", where_, what));
  }

  bool has(const char* key) const { return object_.contains(key); }
  std::string where(const char* key) const { return where_ + "." + key; }

  /// The value itself; has(key).
  const nlohmann::json& value(const char* key) const { return object_.at(key); }

  template <typename Value>
  Value get(const char* key, Value otherwise) const {
    if (!has(key)) {
      return otherwise;
    }
    try {
      return object_.at(key).get<Value>();
    } catch (const nlohmann::json::exception& error) {
      fail(fmt::format("has a wrong '{}': {}", key, error.what()));
    }
  }

  template <typename Value>
  Value need(const char* key) const {
    if (!has(key)) {
      fail(fmt::format("needs a '{}'", key));
    }
    return get(key, Value());
  }

  /// A list of objects, each read by itself.
  template <typename Item>
  std::vector<Item> list(const char* key, std::initializer_list<const char*> keys,
                         Item (*read)(const ScriptPart& part)) const {
    std::vector<Item> items;
    for (const nlohmann::json& item : get(key, nlohmann::json::array())) {
      items.push_back(
          read(ScriptPart(item, fmt::format("{}[{}]", where(key), items.size()), keys)));
    }
    return items;
  }

 private:
  const nlohmann::json& object_;
  std::string where_;
};

}  // namespace foveola::test::openxr
