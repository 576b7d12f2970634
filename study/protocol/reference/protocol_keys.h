// Describes every key of a study's TOML files, as declared by the readers: the source of
// docs/PROTOCOL.md and of protocols/foveola-protocol.schema.json.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/toml/toml_keys.h"

namespace foveola::study {

/// A protocol with the required keys only.
inline constexpr const char* smallest_protocol =
    R"(name = "small"
title = "A small study"
scenes = ["arcade", "church"]
methods = ["od", "fv"]
)";

struct DescribedTable {
  std::string file;  ///< "protocol", "questionnaire file", "display profile", "tracker profile"
  std::string name;  ///< as "tracker.validation"; empty for the file itself
  bool is_list = false;
  bool is_keyed_by_ids =
      false;  ///< its keys are ids chosen by a study; `keys` has the smallest protocol's
  std::string meaning;
  std::vector<TomlKey> keys;  ///< in the order of reading
};

/// Returns whether the key's value is a table, or a list of tables.
bool is_table(const TomlKey& key);

/// Returns each file's own keys first, then its tables, as the readers ask for them when they read
/// examples.
std::vector<DescribedTable> described_tables();

}  // namespace foveola::study
