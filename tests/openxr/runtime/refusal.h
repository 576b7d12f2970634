// What a call is answered that the runtime does not carry out.
#pragma once

#include <stdexcept>
#include <string>

#include "tests/openxr/runtime/interface.h"

namespace foveola::test::openxr {

/// Ends a call with its result. Why is for the log.
class Refusal : public std::runtime_error {
 public:
  Refusal(XrResult result, const std::string& why) : std::runtime_error(why), result_(result) {}
  XrResult result() const { return result_; }

 private:
  XrResult result_;
};

inline void require(bool holds, XrResult otherwise, const char* why) {
  if (!holds) {
    throw Refusal(otherwise, why);
  }
}

/// What the application has given to be read or written, which has to be a structure of its type.
template <typename Structure>
Structure& checked(Structure* given, XrStructureType type, const char* name) {
  if (given == nullptr) {
    throw Refusal(XR_ERROR_VALIDATION_FAILURE, std::string(name) + " is a null pointer");
  }
  if (given->type != type) {
    throw Refusal(XR_ERROR_VALIDATION_FAILURE, std::string(name) + "'s type is " +
                                                   std::to_string(given->type) + ", not " +
                                                   std::to_string(type));
  }
  return *given;
}

/// As above, of what may be left out.
template <typename Structure>
void check_if_given(const Structure* given, XrStructureType type, const char* name) {
  if (given != nullptr) {
    checked(given, type, name);
  }
}

/// Where a result goes.
template <typename Value>
Value& place_for(Value* given, const char* name) {
  if (given == nullptr) {
    throw Refusal(XR_ERROR_VALIDATION_FAILURE, std::string(name) + " is a null pointer");
  }
  return *given;
}

/// The structure of this type that is chained to another, or null.
template <typename Structure>
const Structure* chained(const void* next, XrStructureType type) {
  for (auto* link = static_cast<const XrBaseInStructure*>(next); link != nullptr;
       link = link->next) {
    if (link->type == type) {
      return reinterpret_cast<const Structure*>(link);
    }
  }
  return nullptr;
}

/// As above, to be written.
template <typename Structure>
Structure* chained_result(void* next, XrStructureType type) {
  return const_cast<Structure*>(chained<Structure>(next, type));
}

}  // namespace foveola::test::openxr
