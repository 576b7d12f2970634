// How a call of the application's becomes a result.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "tests/openxr/runtime/interface.h"

namespace foveola::test::openxr {

/// Calls, one at a time, and answers with the result: with the script's where that says so, and
/// with that of a Refusal, which is logged with its reason.
XrResult answer(const char* function, const std::function<XrResult()>& call);

/// A function's name as an argument of a template.
template <std::size_t size>
struct FunctionName {
  consteval FunctionName(const char (&name)[size]) { std::copy_n(name, size, text); }
  char text[size];
};

template <FunctionName name, auto function>
struct Answered;

/// What the application is given to call, for `function`.
template <FunctionName name, typename... Arguments, XrResult (*function)(Arguments...)>
struct Answered<name, function> {
  static XrResult XRAPI_CALL call(Arguments... arguments) {
    return answer(name.text, [&] { return function(arguments...); });
  }
};

}  // namespace foveola::test::openxr
