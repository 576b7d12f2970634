// Reads a protocol's scenes and methods, and its preregistered analysis plan.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "renderer/base/toml/toml_reader.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

std::vector<SceneEntry> read_scenes(TomlReader& reader);

void read_methods(TomlReader& reader, Protocol& protocol);

/// Returns the loaded file of a method; null if the method reads no such file.
const MethodFile* find_method_file(const std::vector<MethodFile>& files, const std::string& method,
                                   const std::string& file);

/// Reads the table [analysis]. The protocol's methods, marks and ratings must have been read.
AnalysisPlan read_analysis(TomlReader reader, const Protocol& protocol);

/// Throws Error for a plan that a new study must not have: comparisons for a single participant, or
/// a comparison planned in both directions. Older records may have such plans.
void require_computable(TomlReader reader, const AnalysisPlan& plan);

}  // namespace foveola::study
