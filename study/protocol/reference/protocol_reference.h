// The reference of protocols for people, docs/PROTOCOL.md, and for programs.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace foveola::study {

/// What a protocol is, where its files are looked for, and every key of described_tables(), in
/// Markdown.
std::string protocol_reference();

/// The keys alone: a list of tables, each with its keys.
nlohmann::ordered_json protocol_reference_json();

}  // namespace foveola::study
