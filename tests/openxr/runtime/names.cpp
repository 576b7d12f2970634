#include "tests/openxr/runtime/names.h"

#include <openxr/openxr_reflection.h>

namespace foveola::test::openxr {
namespace {

std::string behind(const std::string& prefix, const std::string& name) {
  return name.compare(0, prefix.size(), prefix) == 0 ? name.substr(prefix.size()) : name;
}

}  // namespace

// The header's lists are macros, which are given another macro for each of their items.
#define FOVEOLA_CASE(name, value) \
  case name:                      \
    return #name;

std::optional<std::string> name_of(XrResult result) {
  switch (result) { XR_LIST_ENUM_XrResult(FOVEOLA_CASE) default : return std::nullopt; }
}

std::optional<std::string> name_of(XrStructureType type) {
  switch (type) { XR_LIST_ENUM_XrStructureType(FOVEOLA_CASE) default : return std::nullopt; }
}

#undef FOVEOLA_CASE

#define FOVEOLA_COMPARE(name, value) \
  if (text == #name) {               \
    return name;                     \
  }

std::optional<XrResult> result_of_name(const std::string& text) {
  XR_LIST_ENUM_XrResult(FOVEOLA_COMPARE);
  return std::nullopt;
}

#undef FOVEOLA_COMPARE

std::string short_name(XrSessionState state) {
  switch (state) {
#define FOVEOLA_CASE(name, value) \
  case name:                      \
    return behind("XR_SESSION_STATE_", #name);
    XR_LIST_ENUM_XrSessionState(FOVEOLA_CASE)
#undef FOVEOLA_CASE
        default : return std::to_string(state);
  }
}

std::string short_name(XrReferenceSpaceType type) {
  switch (type) {
    case XR_REFERENCE_SPACE_TYPE_VIEW:
      return "VIEW";
    case XR_REFERENCE_SPACE_TYPE_LOCAL:
      return "LOCAL";
    case XR_REFERENCE_SPACE_TYPE_STAGE:
      return "STAGE";
    default:
      return std::to_string(type);
  }
}

}  // namespace foveola::test::openxr
