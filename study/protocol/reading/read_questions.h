// Reads questions: ratings, and questionnaires from the protocol or from files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "renderer/base/toml/toml_reader.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// Reads an id: letters, digits, - and _, since it names records, tables and columns. Throws Error
/// for other characters, and for one of `taken`. meaning: of the key.
std::string read_new_id(TomlReader& reader, std::string_view meaning,
                        const std::vector<std::string>& taken);

/// Returns the questions of the array of tables `key`, which may be absent. Their ids must not be
/// among `taken`.
std::vector<Question> read_questions(TomlReader& reader, std::string_view key,
                                     const std::vector<std::string>& taken,
                                     std::string_view meaning);

/// Returns the questionnaire, without an id, of a file of this text; `name`: the file's. keys: see
/// TomlReader. Throws Error.
Questionnaire read_questionnaire_file(const std::string& name, const std::string& toml,
                                      TomlKeys* keys = nullptr);

/// Returns the content of a questionnaire's file, by its name in the protocol. Throws
/// std::runtime_error if there is no such file.
using QuestionnaireFiles = std::function<std::string(const std::string& name)>;

/// Returns the files in `folder`, by path; and those named NAME.toml there, else among the user's,
/// else among Foveola's own. A protocol of Foveola's uses only the latter.
QuestionnaireFiles questionnaire_files_in(const std::filesystem::path& folder);

/// Returns the protocol's [[questionnaire]] entries.
std::vector<Questionnaire> read_questionnaires(TomlReader& reader, const QuestionnaireFiles& files);

}  // namespace foveola::study
