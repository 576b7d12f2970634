// Generates the reference of protocols for people, docs/PROTOCOL.md, and for programs.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace foveola::study {

/// Returns, in Markdown, an introduction to protocols, the folders of their files, and every key of
/// described_tables().
std::string protocol_reference();

/// Returns the keys alone: a list of tables, each with its keys.
nlohmann::ordered_json protocol_reference_json();

}  // namespace foveola::study
