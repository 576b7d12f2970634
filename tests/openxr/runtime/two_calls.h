// Results of any length, which an application asks for twice: first how long they are, then for
// them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "tests/openxr/runtime/refusal.h"

namespace foveola::test::openxr {

/// Tells the length, and whether the application wants the items as well. Refuses if they do not
/// fit.
inline bool wants_items(std::size_t size, std::uint32_t capacity, std::uint32_t* count,
                        const void* out) {
  place_for(count, "the place for the count") = static_cast<std::uint32_t>(size);
  if (capacity == 0) {
    return false;
  }
  if (capacity < size) {
    throw Refusal(XR_ERROR_SIZE_INSUFFICIENT, "there is room for " + std::to_string(capacity) +
                                                  " items, and there are " + std::to_string(size));
  }
  require(out != nullptr, XR_ERROR_VALIDATION_FAILURE, "there is a capacity, but no array");
  return true;
}

template <typename Item>
void give_items(const std::vector<Item>& items, std::uint32_t capacity, std::uint32_t* count,
                Item* out) {
  if (wants_items(items.size(), capacity, count, out)) {
    std::copy(items.begin(), items.end(), out);
  }
}

/// As above. The application has set each structure's type, and may have chained others to it.
template <typename Structure>
void give_structures(const std::vector<Structure>& items, XrStructureType type,
                     std::uint32_t capacity, std::uint32_t* count, Structure* out) {
  if (!wants_items(items.size(), capacity, count, out)) {
    return;
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    checked(&out[i], type, "an item of the array");
    void* const next = out[i].next;
    out[i] = items[i];
    out[i].type = type;
    out[i].next = next;
  }
}

/// With a null character at its end, which counts.
inline void give_text(const std::string& text, std::uint32_t capacity, std::uint32_t* count,
                      char* out) {
  give_items(std::vector<char>(text.c_str(), text.c_str() + text.size() + 1), capacity, count, out);
}

/// Into an array of a structure, cut off where it does not fit.
template <std::size_t size>
void put_text(const std::string& text, char (&out)[size]) {
  const std::size_t length = std::min(text.size(), size - 1);
  std::copy_n(text.data(), length, out);
  out[length] = '\0';
}

}  // namespace foveola::test::openxr
