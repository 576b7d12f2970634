// Reads a session's procedure: orders, marks, ratings, practice, phases.
#pragma once

#include <vector>

#include "renderer/base/toml/toml_reader.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// Fills the protocol's language and texts.
void read_texts(TomlReader& reader, Protocol& protocol);

/// Returns the published marks, outline and material, and the published rating, artifacts.
std::vector<MarkEntry> published_marks();
std::vector<Question> published_ratings();

/// Returns the protocol's marks; the published ones if it has none.
std::vector<MarkEntry> read_marks(TomlReader& reader);

/// Returns the protocol's ratings, whose ids must differ from the marks'; the published one if it
/// has none.
std::vector<Question> read_ratings(TomlReader& reader, const std::vector<MarkEntry>& marks);

/// Fills the protocol's orders, marks, ratings, practice, catch trials, reaction and looking. Its
/// scenes and methods must have been read.
void read_procedure(TomlReader& reader, Protocol& protocol);

/// Fills the protocol's phases. Everything that they refer to must have been read.
void read_phases(TomlReader& reader, Protocol& protocol);

}  // namespace foveola::study
