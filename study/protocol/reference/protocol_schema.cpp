#include "study/protocol/reference/protocol_schema.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

#include "study/protocol/reference/protocol_keys.h"

namespace foveola::study {
namespace {

using Json = nlohmann::ordered_json;  // Keeps the order of reading.

Json json_of(double number) {
  return number == std::round(number) ? Json(static_cast<std::int64_t>(number)) : Json(number);
}

class SchemaWriter {
 public:
  explicit SchemaWriter(const std::vector<DescribedTable>& tables) : tables_(tables) {}

  Json schema_of(const DescribedTable& table) const {
    Json schema = {{"type", "object"}};
    if (table.is_keyed_by_ids) {
      const auto smallest = std::ranges::min_element(table.keys, {}, &TomlKey::minimum);
      schema["additionalProperties"] = {{"description", smallest->meaning},
                                        {"type", "number"},
                                        {"minimum", json_of(*smallest->minimum)}};
      return schema;
    }
    schema["properties"] = Json::object();
    schema["additionalProperties"] = false;
    for (const TomlKey& key : table.keys) {
      schema["properties"][key.key] = property_of(key, table);
      if (key.is_required) {
        schema["required"].push_back(key.key);
      }
    }
    return schema;
  }

 private:
  const DescribedTable& inner_table(const TomlKey& key, const DescribedTable& outer) const {
    const std::string name = outer.name.empty() ? key.key : outer.name + "." + key.key;
    return *std::ranges::find_if(tables_, [&](const DescribedTable& table) {
      return table.file == outer.file && table.name == name;
    });
  }

  static Json with_range(Json number, const TomlKey& key) {
    if (key.minimum && key.words.empty()) {
      number["minimum"] = json_of(*key.minimum);
      number["maximum"] = json_of(*key.maximum);
    }
    return number;
  }

  /// type: one of the key's.
  Json value_of(const std::string& type, const TomlKey& key, const DescribedTable& table) const {
    if (is_table(key)) {
      const DescribedTable& inner = inner_table(key, table);
      return inner.is_list ? Json{{"type", "array"}, {"minItems", 1}, {"items", schema_of(inner)}}
                           : schema_of(inner);
    }
    if (type == "list of texts") {
      return {{"type", "array"},
              {"minItems", 1},
              {"uniqueItems", true},
              {"items", {{"type", "string"}}}};
    }
    if (type.starts_with("list of ")) {
      const int count = std::stoi(type.substr(type.find_first_of("0123456789")));
      return {{"type", "array"},
              {"minItems", count},
              {"maxItems", count},
              {"items", with_range({{"type", "number"}}, key)}};
    }
    return with_range({{"type", type == "text"            ? "string"
                                : type == "true or false" ? "boolean"
                                : type == "whole number"  ? "integer"
                                                          : "number"}},
                      key);
  }

  Json property_of(const TomlKey& key, const DescribedTable& table) const {
    Json property = Json::object();
    if (!key.meaning.empty()) {
      property["description"] = key.meaning;
    }
    if (key.types.size() == 1) {
      property.update(value_of(key.types.front(), key, table));
    } else {
      for (const std::string& type : key.types) {
        property["anyOf"].push_back(value_of(type, key, table));
      }
    }
    if (!key.pattern.empty()) {
      property["pattern"] = key.pattern;
    }
    const bool is_text = key.types.front() == "text";
    for (const std::string& word : key.words) {
      property["enum"].push_back(is_text ? Json(word) : Json::parse(word));
    }
    if (key.default_text) {
      property["default"] = is_text ? Json(*key.default_text) : Json::parse(*key.default_text);
    }
    return property;
  }

  const std::vector<DescribedTable>& tables_;
};

}  // namespace

std::string protocol_schema() {
  const std::vector<DescribedTable> tables = described_tables();
  const SchemaWriter writer(tables);
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "Foveola study protocol"},
                 {"description", tables.front().meaning}};
  schema.update(writer.schema_of(tables.front()));
  for (const DescribedTable& table : tables) {
    if (table.name.empty() && table.file != tables.front().file) {
      std::string name = table.file;
      std::ranges::replace(name, ' ', '_');
      Json& definition = schema["definitions"][name];
      definition = {{"description", table.meaning}};
      definition.update(writer.schema_of(table));
    }
  }
  return schema.dump(2) + "\n";
}

}  // namespace foveola::study
