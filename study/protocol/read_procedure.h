// How a session goes: orders, marks, ratings, practice, phases.
#pragma once

#include "renderer/base/toml_reader.h"
#include "study/protocol/protocol.h"

namespace foveola::study {

/// Fills the protocol's language and texts.
void read_texts(TomlReader& reader, Protocol& protocol);

/// Fills the protocol's orders, marks, ratings, practice, catch trials and reaction. Its scenes and
/// methods must have been read.
void read_procedure(TomlReader& reader, Protocol& protocol);

/// Fills the protocol's phases. All that they are about must have been read.
void read_phases(TomlReader& reader, Protocol& protocol);

}  // namespace foveola::study
