// What a protocol plans to compare before there are data.
#pragma once

#include "renderer/base/toml_reader.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// The table [analysis]. The protocol's methods, marks and ratings must have been read.
AnalysisPlan read_analysis(TomlReader reader, const Protocol& protocol);

}  // namespace foveola::study
