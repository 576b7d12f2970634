// Reads the part of a protocol that plans the analysis before there are data.
#pragma once

#include "renderer/base/toml_reader.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// Reads the table [analysis]. The protocol's methods, marks and ratings must have been read.
AnalysisPlan read_analysis(TomlReader reader, const Protocol& protocol);

}  // namespace foveola::study
