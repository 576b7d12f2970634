// The objects that an application knows by handles.
#pragma once

#include <bit>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "tests/openxr/runtime/refusal.h"

namespace foveola::test::openxr {

/// All objects of a kind. A handle is never used twice, so that what was destroyed is never
/// mistaken for what was made later.
template <typename Handle, typename Object>
class Handles {
 public:
  explicit Handles(std::string kind) : kind_(std::move(kind)) {}

  Handle add(std::shared_ptr<Object> object) {
    const std::uint64_t number = ++last_number_;
    objects_[number] = std::move(object);
    return handle_of(number);
  }

  /// Refuses handles that are unknown or were destroyed.
  std::shared_ptr<Object> at(Handle handle) const {
    const auto found = objects_.find(number_of(handle));
    if (found == objects_.end()) {
      const bool was_there = number_of(handle) > 0 && number_of(handle) <= last_number_;
      throw Refusal(
          XR_ERROR_HANDLE_INVALID,
          "the " + kind_ + (was_there ? " was destroyed" : " is not one of this runtime"));
    }
    return found->second;
  }

  std::shared_ptr<Object> remove(Handle handle) {
    std::shared_ptr<Object> object = at(handle);
    objects_.erase(number_of(handle));
    return object;
  }

  void clear() { objects_.clear(); }
  const std::map<std::uint64_t, std::shared_ptr<Object>>& all() const { return objects_; }
  /// As the log numbers it: from 1, in the order of making.
  static std::uint64_t number_of(Handle handle) { return std::bit_cast<std::uint64_t>(handle); }

 private:
  static Handle handle_of(std::uint64_t number) { return std::bit_cast<Handle>(number); }

  std::string kind_;
  std::map<std::uint64_t, std::shared_ptr<Object>> objects_;
  std::uint64_t last_number_ = 0;
};

}  // namespace foveola::test::openxr
