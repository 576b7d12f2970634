// One value made of each item of a container.
#pragma once

#include <functional>
#include <iterator>
#include <type_traits>
#include <vector>

namespace foveola {

/// What `function`, which may be a member of the items, gives for each item, in their order. The
/// vector has elements of type Value, by default what the function returns.
template <typename Value = void, typename Items, typename Function>
auto transformed(const Items& items, const Function& function) {
  using Result =
      std::remove_cvref_t<std::invoke_result_t<const Function&, decltype(*std::begin(items))>>;
  std::vector<std::conditional_t<std::is_void_v<Value>, Result, Value>> values;
  values.reserve(std::size(items));
  for (const auto& item : items) {
    values.emplace_back(std::invoke(function, item));
  }
  return values;
}

}  // namespace foveola
