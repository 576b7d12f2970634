// The schemas of a study's file, built into the program from schema.sql.
#pragma once

#include <cstdint>
#include <string>

namespace SQLite {
class Database;
}

namespace foveola::study {

/// "Fovl" in ASCII: marks an SQLite file as a study of Foveola.
constexpr std::int32_t study_application_id = 0x466F766C;
/// The schema in which sessions are recorded.
constexpr std::int32_t study_schema_version = 5;
/// The oldest that is read. Its log says nothing of frames, gaze and films.
constexpr std::int32_t oldest_schema_version = 4;
/// The program that records sessions in it.
constexpr const char* program_of_oldest_schema = "Foveola 0.1.0";

/// What schema.sql says of a version, to the letter.
std::string study_schema(int version = study_schema_version);

/// That of a study that is open.
int schema_version_of(SQLite::Database& study);

}  // namespace foveola::study
