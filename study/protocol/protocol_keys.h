// Every key of a study's TOML files: what the readers ask of it, and what it means. The reference
// for readers, docs/PROTOCOL.md, is made from this.
#pragma once

#include <string>
#include <vector>

#include "renderer/base/toml/toml_keys.h"

namespace foveola::study {

struct DescribedKey {
  TomlKey rule;
  std::string meaning;
};

struct DescribedTable {
  std::string file;  ///< "protocol", "questionnaire file", "display profile", "tracker profile"
  std::string name;  ///< as "tracker.validation"; empty for the file itself
  bool is_list = false;
  bool is_keyed_by_ids = false;  ///< its keys are ids that a study chooses; those of the example
  std::string meaning;
  std::vector<DescribedKey> keys;  ///< in the schema's order
};

/// What the readers ask for when they read the schema's examples, with the schema's descriptions.
/// Throws std::logic_error for a key that only the readers or only the schema know.
std::vector<DescribedTable> described_tables();

}  // namespace foveola::study
