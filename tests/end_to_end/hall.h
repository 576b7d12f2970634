// A scene "hall", made for the tests, and a study of it: seconds of work.
#pragma once

#include <string>
#include <vector>

#include "tests/end_to_end/program.h"

namespace foveola::test {

/// One scene, one method, a film of 32 x 16.
extern const char* const hall_protocol;
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
