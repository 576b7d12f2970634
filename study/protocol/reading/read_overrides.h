// Reads the settings of a protocol that hold for one scene, one method, or both.
#pragma once

#include "renderer/base/toml/toml_reader.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// Fills the protocol's cells. All its other settings must have been read.
void read_overrides(TomlReader& reader, Protocol& protocol);

}  // namespace foveola::study
