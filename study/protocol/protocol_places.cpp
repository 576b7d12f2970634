#include "study/protocol/protocol_places.h"

#include <fmt/format.h>

#include "renderer/base/toml/toml_file.h"

namespace foveola::study {

ProtocolPlaces::ProtocolPlaces(const Protocol& protocol)
    : file_(protocol.path.string()),
      table_(parse_toml(file_, protocol.text, "see protocols/demo.toml for an example")) {}

std::string ProtocolPlaces::of(const std::string& toml_path) const {
  const toml::node* const node = toml::at_path(table_, toml_path).node();
  return node == nullptr ? file_
                         : fmt::format("{}:{}:{}", file_, node->source().begin.line,
                                       node->source().begin.column);
}

bool ProtocolPlaces::has(const std::string& toml_path) const {
  return static_cast<bool>(toml::at_path(table_, toml_path));
}

}  // namespace foveola::study
