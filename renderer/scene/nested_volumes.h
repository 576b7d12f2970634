// Volumes within volumes, such as water in a glass: there are no nested dielectrics, outside of
// each volume is air.
#pragma once

#include <optional>
#include <string>

#include "renderer/scene/scene.h"

namespace foveola {

/// A line that says so of the first object of refracting material whose bounds lie within those of
/// another, if there is one: it may as well stand in the other's hollow. Of very many such
/// objects, not all are looked at.
std::optional<std::string> warning_of_nested_volumes(const Scene& scene);

}  // namespace foveola
