#include "study/protocol/protocol_keys.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "study/protocol/schema_tables.h"

namespace foveola::study {
namespace {

/// What the readers ask for in files with these tables.
std::vector<TomlKey> keys_read(const std::vector<SchemaTable>& tables) {
  TomlKeys keys;
  for (const SchemaTable& table : tables) {
    for (const SchemaJson& example : table.examples) {
      table.complaint(example, &keys);
    }
  }
  return keys.keys();
}

DescribedKey described(const TomlKey& key, const SchemaJson& property) {
  return {.rule = key, .meaning = property.value("description", "")};
}

DescribedTable described(const SchemaTable& table, const std::vector<TomlKey>& keys) {
  DescribedTable result{.file = table.file->name,
                        .name = table.name,
                        .is_list = table.is_list,
                        .is_keyed_by_ids = false,
                        .meaning = table.meaning,
                        .keys = {}};
  const SchemaJson& properties = table.schema.at("properties");
  for (const auto& [name, property] : properties.items()) {
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const TomlKey& known) {
      return known.table == table.name && known.key == name;
    });
    if (key == keys.end()) {
      throw std::logic_error(fmt::format("no reader of a {} asks for '{}' in [{}]",
                                         table.file->name, name, table.name));
    }
    result.keys.push_back(described(*key, property));
  }
  for (const TomlKey& key : keys) {
    if (key.table == table.name && !properties.contains(key.key)) {
      throw std::logic_error(fmt::format("the schema does not describe '{}' in [{}] of a {}",
                                         key.key, table.name, table.file->name));
    }
  }
  return result;
}

/// A table whose keys are not the readers' own.
DescribedTable keyed_by_ids(const SchemaTable& outer, const std::string& key,
                            const SchemaJson& property, const std::vector<TomlKey>& keys) {
  DescribedTable result{.file = outer.file->name,
                        .name = outer.name.empty() ? key : outer.name + "." + key,
                        .is_list = false,
                        .is_keyed_by_ids = true,
                        .meaning = property.value("description", ""),
                        .keys = {}};
  for (const TomlKey& known : keys) {
    if (known.table == result.name) {
      result.keys.push_back(described(known, property.at("additionalProperties")));
    }
  }
  return result;
}

}  // namespace

std::vector<DescribedTable> described_tables() {
  const std::vector<SchemaTable> tables = schema_tables();
  std::vector<DescribedTable> result;
  for (auto begin = tables.begin(); begin != tables.end();) {
    const auto end = std::find_if(begin + 1, tables.end(),
                                  [](const SchemaTable& table) { return table.name.empty(); });
    const std::vector<TomlKey> keys = keys_read(std::vector(begin, end));
    // Further examples would have further ids.
    const std::vector<TomlKey> keys_of_smallest = keys_read(std::vector{*begin});
    for (; begin != end; ++begin) {
      result.push_back(described(*begin, keys));
      for (const auto& [key, property] : begin->schema.at("properties").items()) {
        if (property.value("type", "") == "object" && !property.contains("properties")) {
          result.push_back(keyed_by_ids(*begin, key, property, keys_of_smallest));
        }
      }
    }
  }
  return result;
}

}  // namespace foveola::study
