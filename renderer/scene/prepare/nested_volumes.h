// Warns of nested volumes, such as water in a glass. Nested dielectrics are not supported: the
// medium around each volume is air.
#pragma once

#include <optional>
#include <string>

#include "renderer/scene/scene.h"

namespace foveola {

/// A warning about the first refracting object whose bounds lie within another's, if any; it may
/// also stand in the other's hollow. Of very many such objects only some are tested.
std::optional<std::string> warning_of_nested_volumes(const Scene& scene);

}  // namespace foveola
