// A mesh that Draco compressed.
#pragma once

#include <string>

namespace foveola::test {

enum class DracoMethod { sequential, edgebreaker };

/// The unit square at z = 0, two triangles with their positions as attribute 0 and, as attribute 1,
/// texture coordinates that are the same.
std::string draco_square(DracoMethod method);

}  // namespace foveola::test
