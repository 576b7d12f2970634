// Reads the part of a protocol that plans the analysis before there are data.
#pragma once

#include "renderer/base/toml_reader.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// Reads the table [analysis]. The protocol's methods, marks and ratings must have been read.
AnalysisPlan read_analysis(TomlReader reader, const Protocol& protocol);

/// Throws Error for a plan that no new study should begin with: comparisons for a single
/// participant, and one that is planned in both directions. Older records may have such.
void require_computable(TomlReader reader, const AnalysisPlan& plan);

}  // namespace foveola::study
