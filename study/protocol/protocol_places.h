// Where things of a protocol stand in its file, for messages about what they mean together.
#pragma once

#include <string>

#include "renderer/base/toml_reader.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

class ProtocolPlaces {
 public:
  explicit ProtocolPlaces(const Protocol& protocol);

  /// FILE:LINE:COLUMN of what stands at a path of TOML, as "rating[1].maximum" or
  /// "analysis.primary[0].measure"; of the protocol's file alone if nothing does.
  std::string of(const std::string& toml_path) const;

 private:
  std::string file_;
  toml::table table_;
};

}  // namespace foveola::study
