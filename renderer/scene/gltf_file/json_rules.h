// Rules for the shape of a JSON document, which make a schema read like the specification.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace foveola::json_rules {

/// A value's place in the document, formatted as "meshes[3].name" only for a fault.
struct Place {
  const Place* parent = nullptr;
  std::string_view key;   ///< name of an object's member; empty for an array's element
  std::size_t index = 0;  ///< position of an array's element

  std::string path() const;
};

/// Throws GltfFault at the place unless the value obeys.
using Rule = std::function<void(const nlohmann::json& value, const Place& place)>;

enum class Presence : std::uint8_t { optional, required };

struct Property {
  std::string name;
  Presence presence;
  Rule rule;
};

Rule text();
Rule boolean();
Rule one_of(std::vector<std::string> texts);
/// An integer in [lowest, highest], which may be written as 1.0.
Rule integer(std::int64_t lowest, std::int64_t highest);
Rule one_of_integers(std::vector<std::int64_t> values);
Rule number(double lowest, double highest);
/// An array of exactly `count` numbers.
Rule numbers(std::size_t count);
/// An integer index into the array `name`, which has `size` elements.
Rule index_into(std::string name, std::size_t size);
/// An array of at least `fewest` elements that obey `element`.
Rule array_of(Rule element, std::size_t fewest = 0);
/// An object with any keys, whose values obey `member`.
Rule map_of(Rule member);
/// An object with these properties; others are ignored.
Rule object(std::vector<Property> properties);

}  // namespace foveola::json_rules
