#include "renderer/scene/gltf_file/json_rules.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "renderer/scene/gltf_file/fault.h"

namespace foveola::json_rules {
namespace {

using Json = nlohmann::json;

void require(bool obeyed, const Place& place, const std::string& what) {
  if (!obeyed) {
    throw GltfFault(place.path(), what);
  }
}

/// Some programs write 1.0 for 1. -0.0 is never an index or count.
bool is_integer(const Json& value) {
  if (!value.is_number_float()) {
    return value.is_number_integer();
  }
  const auto number = value.get<double>();
  return std::trunc(number) == number && !(number == 0.0 && std::signbit(number));
}

bool is_integer_within(const Json& value, std::int64_t lowest, std::int64_t highest) {
  if (value.is_number_float()) {
    const auto number = value.get<double>();
    return is_integer(value) && number >= static_cast<double>(lowest) &&
           number <= static_cast<double>(highest);
  }
  if (value.is_number_unsigned()) {
    const auto number = value.get<std::uint64_t>();
    return highest >= 0 && number <= static_cast<std::uint64_t>(highest) &&
           (lowest <= 0 || number >= static_cast<std::uint64_t>(lowest));
  }
  return value.is_number_integer() && value.get<std::int64_t>() >= lowest &&
         value.get<std::int64_t>() <= highest;
}

}  // namespace

std::string Place::path() const {
  if (parent == nullptr) {
    return std::string(key);
  }
  const std::string above = parent->path();
  if (key.empty()) {
    return fmt::format("{}[{}]", above, index);
  }
  return above.empty() ? std::string(key) : fmt::format("{}.{}", above, key);
}

Rule text() {
  return [](const Json& value, const Place& place) {
    require(value.is_string(), place, "must be a text");
  };
}

Rule boolean() {
  return [](const Json& value, const Place& place) {
    require(value.is_boolean(), place, "must be true or false");
  };
}

Rule one_of(std::vector<std::string> texts) {
  return [texts = std::move(texts)](const Json& value, const Place& place) {
    require(value.is_string() && std::ranges::count(texts, value.get<std::string>()) > 0, place,
            fmt::format("must be one of {}", fmt::join(texts, ", ")));
  };
}

Rule integer(std::int64_t lowest, std::int64_t highest) {
  return [=](const Json& value, const Place& place) {
    require(is_integer_within(value, lowest, highest), place,
            fmt::format("must be an integer from {} to {}", lowest, highest));
  };
}

Rule one_of_integers(std::vector<std::int64_t> values) {
  return [values = std::move(values)](const Json& value, const Place& place) {
    require(is_integer(value) && std::count(values.begin(), values.end(), value) > 0, place,
            fmt::format("must be one of {}", fmt::join(values, ", ")));
  };
}

Rule number(double lowest, double highest) {
  return [=](const Json& value, const Place& place) {
    require(value.is_number() && value.get<double>() >= lowest && value.get<double>() <= highest,
            place, fmt::format("must be a number from {} to {}", lowest, highest));
  };
}

Rule numbers(std::size_t count) {
  return [=](const Json& value, const Place& place) {
    require(
        value.is_array() && value.size() == count &&
            std::all_of(value.begin(), value.end(), [](const Json& v) { return v.is_number(); }),
        place, fmt::format("must be {} numbers", count));
  };
}

Rule index_into(std::string name, std::size_t size) {
  return [name = std::move(name), size](const Json& value, const Place& place) {
    require(is_integer(value), place, fmt::format("must be an index into {}", name));
    require(is_integer_within(value, 0, static_cast<std::int64_t>(size) - 1), place,
            fmt::format(
                "is {}, but {} has {} elements",
                value.is_number_float() ? fmt::format("{:.0f}", value.get<double>()) : value.dump(),
                name, size));
  };
}

Rule array_of(Rule element, std::size_t fewest) {
  return [element = std::move(element), fewest](const Json& value, const Place& place) {
    require(value.is_array(), place, "must be an array");
    require(value.size() >= fewest, place, fmt::format("must have {} or more elements", fewest));
    for (std::size_t i = 0; i < value.size(); ++i) {
      element(value[i], Place{.parent = &place, .key = {}, .index = i});
    }
  };
}

Rule map_of(Rule member) {
  return [member = std::move(member)](const Json& value, const Place& place) {
    require(value.is_object(), place, "must be an object");
    for (const auto& [key, item] : value.items()) {
      member(item, Place{.parent = &place, .key = key});
    }
  };
}

Rule object(std::vector<Property> properties) {
  return [properties = std::move(properties)](const Json& value, const Place& place) {
    require(value.is_object(), place, "must be an object");
    for (const Property& property : properties) {
      const Place member{.parent = &place, .key = property.name};
      if (const auto found = value.find(property.name); found != value.end()) {
        property.rule(*found, member);
      } else {
        require(property.presence == Presence::optional, member, "is missing");
      }
    }
  };
}

}  // namespace foveola::json_rules
