// The schema of a study's file, built into the program from schema.sql.
#pragma once

#include <cstdint>

namespace foveola::study {

/// "Fovl" in ASCII: marks an SQLite file as a study of Foveola.
constexpr std::int32_t study_application_id = 0x466F766C;
/// The schema that this program reads and writes.
constexpr std::int32_t study_schema_version = 4;

/// schema.sql, to the letter.
const char* study_schema();

}  // namespace foveola::study
