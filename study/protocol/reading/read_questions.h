// Reads questions: ratings, and questionnaires from the protocol or from files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "renderer/base/toml/toml_reader.h"
#include "study/protocol/questionnaire.h"

namespace foveola::study {

/// Reads an id: letters, digits, - and _, since records, tables and columns are named by it. Throws
/// Error for other characters, and for one of `taken`. meaning: of the key.
std::string read_new_id(TomlReader& reader, std::string_view meaning,
                        const std::vector<std::string>& taken);

/// The questions of the array of tables `key`, which may be absent. Their ids may be none of
/// `taken`.
std::vector<Question> read_questions(TomlReader& reader, std::string_view key,
                                     const std::vector<std::string>& taken,
                                     std::string_view meaning);

/// The questionnaire, without an id, of a file of this text; `name` is the file's. keys: see
/// TomlReader. Throws Error.
Questionnaire read_questionnaire_file(const std::string& name, const std::string& toml,
                                      TomlKeys* keys = nullptr);

/// The content of a questionnaire's file, by the name that the protocol has for it. Throws
/// std::runtime_error if there is no such file.
using QuestionnaireFiles = std::function<std::string(const std::string& name)>;

/// The files in `folder`, by path, and by name NAME.toml there, else among the user's, else among
/// those that come with Foveola. A protocol that comes with it means the latter.
QuestionnaireFiles questionnaire_files_in(const std::filesystem::path& folder);

/// The protocol's [[questionnaire]] entries.
std::vector<Questionnaire> read_questionnaires(TomlReader& reader, const QuestionnaireFiles& files);

}  // namespace foveola::study
