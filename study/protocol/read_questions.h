// What participants answer: ratings, and questionnaires of the protocol's own or of files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "renderer/base/toml_reader.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// An id: letters, digits, - and _, since records, tables and columns are called by it. Throws
/// Error for another one, and for one of `taken`.
std::string read_new_id(TomlReader& reader, const std::vector<std::string>& taken);

/// The questions of the array of tables `key`, which may be absent. `taken`: ids that they may not
/// have.
std::vector<Question> read_questions(TomlReader& reader, std::string_view key,
                                     const std::vector<std::string>& taken);

/// The protocol's [[questionnaire]] entries. folder: where files lie that are named by a path.
std::vector<Questionnaire> read_questionnaires(TomlReader& reader,
                                               const std::filesystem::path& folder);

}  // namespace foveola::study
