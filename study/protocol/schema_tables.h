// The tables that a study's TOML files can have, as the schema for editors describes them, each in
// files that have it: what shows by example what the readers of all tables take.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "renderer/base/toml/toml_keys.h"

namespace foveola::study {

/// Keeps the schema's order.
using SchemaJson = nlohmann::ordered_json;

/// A kind of TOML file of a study.
struct SchemaFile {
  std::string name;  ///< as "questionnaire file"
  SchemaJson schema;
  /// Reads a text as such a file; keys: see TomlReader. Throws Error.
  std::function<void(const std::string& toml, TomlKeys* keys)> read;
};

struct SchemaTable {
  std::shared_ptr<const SchemaFile> file;
  std::string name;  ///< as "tracker.validation"; empty for the file itself
  bool is_list = false;
  std::string meaning;               ///< of all of a list
  SchemaJson schema;                 ///< with "properties", whose $refs are resolved
  SchemaJson document;               ///< a valid file with the table in it
  SchemaJson::json_pointer place;    ///< of the table, or of the first of a list, in it
  std::vector<SchemaJson> examples;  ///< at least one

  /// The file with this table in place of its own, as TOML.
  std::string toml_with(const SchemaJson& content) const;
  /// What the reader says against that; empty if it accepts it. keys: see TomlReader.
  std::string complaint(const SchemaJson& content, TomlKeys* keys = nullptr) const;
};

/// Every table of protocols, questionnaires' files, and profiles of displays and trackers, by
/// protocols/foveola-protocol.schema.json: each file's own keys first, then the tables in it.
/// Throws std::logic_error if no example of a table's surroundings can have it.
std::vector<SchemaTable> schema_tables();

}  // namespace foveola::study
