// What the eyes see from where.
#pragma once

#include <vector>

#include "tests/openxr/runtime/spaces.h"

namespace foveola::test::openxr {

/// Of both eyes, the left one first.
std::vector<XrView> views_in(const Session& session, const Space& space, XrTime time);

}  // namespace foveola::test::openxr
