// A scene "hall", made for the tests, a study of it, and tables for others: seconds of work.
#pragma once

#include <string>
#include <vector>

#include "tests/end_to_end/program.h"

namespace foveola::test {

/// A protocol's machine, film of 32 x 16, display and reference.
extern const char* const small_tables;
/// With them; one scene, one method.
std::string hall_protocol();

/// A protocol's questionnaire. questions: the keys of each, on lines of their own.
std::string questionnaire_table(const std::string& id, const std::vector<std::string>& questions);
/// For a number from 18 to 99, "age".
extern const char* const age_question;

/// With no SHA-256.
extern const char* const hall_descriptor;
/// room_gltf() as a .glb of its JSON alone.
std::string room_glb();

/// A folder in which the program finds them instead of its own: share/protocols/hall.toml,
/// share/scenes/hall.toml, real/hall.glb; and where it keeps its cache.
struct Hall {
  Hall();

  Environment environment() const;
  ProgramResult run(const std::vector<std::string>& arguments) const;

  TemporaryFolder folder;
};

}  // namespace foveola::test
