#include "study/record/setup/amendment_note.h"

#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/files/digest.h"
#include "study/record/log/json_member.h"

namespace foveola::study {
namespace {

constexpr std::string_view beginning = "goes by an amended protocol, SHA-256 ";
constexpr std::string_view before_keys = "; changed: ";
constexpr std::string_view between_keys = ", ";
constexpr std::string_view no_keys = "comments only";
constexpr std::string_view before_files = "; files: ";
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
  const std::string files =
      amendment.files.empty()
          ? ""
          : fmt::format("{}{}", before_files, nlohmann::json(amendment.files).dump());
  return fmt::format("{}{}{}{}{}\n{}", beginning, amendment.sha256, before_keys, keys, files,
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
  const std::string_view changes = line.substr(keys + before_keys.size());
  const std::size_t end_of_keys = changes.find(before_files);
  Amendment amendment{.sha256 = std::string(line.substr(beginning.size(), digits_of_hash)),
                      .changed = keys_in(changes.substr(0, end_of_keys)),
                      .text = note.substr(end_of_line + 1)};
  if (end_of_keys != std::string_view::npos) {
    const nlohmann::ordered_json files =
        parse_json(std::string(changes.substr(end_of_keys + before_files.size())));
    for (const auto& [name, text] : files.items()) {
      amendment.files.emplace(name, text.is_string() ? text.get<std::string>() : "");
    }
  }
  return sha256(std::string_view(amendment.text)) == amendment.sha256
             ? std::optional(std::move(amendment))
             : std::nullopt;
}

}  // namespace foveola::study
