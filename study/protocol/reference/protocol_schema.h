// Generates the schema of a study's TOML files, protocols/foveola-protocol.schema.json, by which
// editors complete and explain keys.
#pragma once

#include <string>

namespace foveola::study {

/// Returns a JSON schema, draft 7, of protocols, with the other kinds of files as its definitions:
/// "questionnaire_file", "display_profile" and "tracker_profile".
std::string protocol_schema();

}  // namespace foveola::study
