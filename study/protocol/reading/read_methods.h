// Reads what a protocol compares, its scenes and methods, and the part that plans the analysis
// before there are data.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "renderer/base/toml/toml_reader.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

std::vector<SceneEntry> read_scenes(TomlReader& reader);

/// Fills the protocol's methods and their files.
void read_methods(TomlReader& reader, Protocol& protocol);

/// The loaded file of a method; null if the method reads no such file.
const MethodFile* find_method_file(const std::vector<MethodFile>& files, const std::string& method,
                                   const std::string& file);

/// Reads the table [analysis]. The protocol's methods, marks and ratings must have been read.
AnalysisPlan read_analysis(TomlReader reader, const Protocol& protocol);

/// Throws Error for a plan that no new study should begin with: comparisons for a single
/// participant, and one that is planned in both directions. Older records may have such.
void require_computable(TomlReader reader, const AnalysisPlan& plan);

}  // namespace foveola::study
