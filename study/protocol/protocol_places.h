// Finds the places of a protocol's keys in its file, for messages about several keys together.
#pragma once

#include <string>

#include "renderer/base/toml/toml_reader.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

class ProtocolPlaces {
 public:
  explicit ProtocolPlaces(const Protocol& protocol);

  /// Returns FILE:LINE:COLUMN of the value at a TOML path, as "rating[1].maximum" or
  /// "analysis.primary[0].measure"; FILE alone if there is none.
  std::string of(const std::string& toml_path) const;

  bool has(const std::string& toml_path) const;

 private:
  std::string file_;
  toml::table table_;
};

}  // namespace foveola::study
