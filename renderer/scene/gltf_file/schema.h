// The specification's tables of properties, as far as the loader reads them.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace foveola {

/// Throws GltfFault unless every property of `document` that the loader reads has its specified
/// type, every index refers to an element, and every buffer view lies inside its buffer's stated
/// length.
void require_schema(const nlohmann::json& document);

}  // namespace foveola
