// Reads questions: ratings, and questionnaires from the protocol or from files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "renderer/base/toml_reader.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// Reads an id: letters, digits, - and _, since records, tables and columns are named by it. Throws
/// Error for other characters, and for one of `taken`.
std::string read_new_id(TomlReader& reader, const std::vector<std::string>& taken);

/// The questions of the array of tables `key`, which may be absent. Their ids may be none of
/// `taken`.
std::vector<Question> read_questions(TomlReader& reader, std::string_view key,
                                     const std::vector<std::string>& taken);

/// The protocol's [[questionnaire]] entries. `folder` is that of files that are named by a path.
std::vector<Questionnaire> read_questionnaires(TomlReader& reader,
                                               const std::filesystem::path& folder);

}  // namespace foveola::study
