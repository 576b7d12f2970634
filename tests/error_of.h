// Refusals, for tests that look at what they say.
#pragma once

#include <functional>
#include <string>

#include "renderer/base/error.h"

namespace foveola::test {

/// The message of the Error that `act` throws; empty if it throws none.
inline std::string error_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace foveola::test
