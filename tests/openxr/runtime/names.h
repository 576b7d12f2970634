// What OpenXR calls its values.
#pragma once

#include <optional>
#include <string>

#include "tests/openxr/runtime/interface.h"

namespace foveola::test::openxr {

/// Nothing for a value that the header does not know.
std::optional<std::string> name_of(XrResult result);
std::optional<std::string> name_of(XrStructureType type);
std::optional<XrResult> result_of_name(const std::string& name);
/// Without XR_SESSION_STATE_ before it.
std::string short_name(XrSessionState state);
/// Without XR_REFERENCE_SPACE_TYPE_ before it.
std::string short_name(XrReferenceSpaceType type);

}  // namespace foveola::test::openxr
