#include "study/record/amendment_note.h"

#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/digest.h"

namespace foveola::study {
namespace {

constexpr std::string_view beginning = "goes by an amended protocol, SHA-256 ";
constexpr std::string_view before_keys = "; changed: ";
constexpr std::string_view between_keys = ", ";
constexpr std::string_view no_keys = "comments only";
constexpr std::size_t digits_of_hash = 64;

std::vector<std::string> keys_in(std::string_view words) {
  std::vector<std::string> keys;
  while (!words.empty() && words != no_keys) {
    const std::size_t end = words.find(between_keys);
    keys.emplace_back(words.substr(0, end));
    words = end == std::string_view::npos ? "" : words.substr(end + between_keys.size());
  }
  return keys;
}

}  // namespace

std::string note_of(const Amendment& amendment) {
  const std::string keys = amendment.changed.empty()
                               ? std::string(no_keys)
                               : fmt::format("{}", fmt::join(amendment.changed, between_keys));
  return fmt::format("{}{}{}{}\n{}", beginning, amendment.sha256, before_keys, keys,
                     amendment.text);
}

std::optional<Amendment> amendment_in(const std::string& note) {
  const std::size_t end_of_line = note.find('\n');
  const std::string_view line = std::string_view(note).substr(0, end_of_line);
  const std::size_t keys = beginning.size() + digits_of_hash;
  if (end_of_line == std::string::npos || !line.starts_with(beginning) || line.size() < keys ||
      !line.substr(keys).starts_with(before_keys)) {
    return std::nullopt;
  }
  Amendment amendment{.sha256 = std::string(line.substr(beginning.size(), digits_of_hash)),
                      .changed = keys_in(line.substr(keys + before_keys.size())),
                      .text = note.substr(end_of_line + 1)};
  return sha256(std::string_view(amendment.text)) == amendment.sha256
             ? std::optional(std::move(amendment))
             : std::nullopt;
}

}  // namespace foveola::study
