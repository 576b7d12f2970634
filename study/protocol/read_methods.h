// Reads what a protocol compares: its scenes, its methods and the files that these read.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "renderer/base/toml_reader.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

std::vector<SceneEntry> read_scenes(TomlReader& reader);

/// Fills the protocol's methods and their files.
void read_methods(TomlReader& reader, Protocol& protocol);

/// The loaded file of a method; null if the method reads no such file.
const MethodFile* find_method_file(const std::vector<MethodFile>& files, const std::string& method,
                                   const std::string& file);

}  // namespace foveola::study
