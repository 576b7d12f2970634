#include "study/record/maintain/remaining_copies.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <regex>
#include <system_error>

#include <fmt/format.h>

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

bool is_of_word(char letter) {
  return (letter >= '0' && letter <= '9') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= 'a' && letter <= 'z') || static_cast<unsigned char>(letter) >= 0x80;
}

/// A short code stands in compressed bytes by chance, but not in texts.
bool is_text(std::string_view bytes) { return bytes.find('\0') == std::string_view::npos; }

/// Whether the UUID stands anywhere but in a line of a head (study_head.h), which is kept for good.
bool has_uuid(std::string_view bytes, const std::string& uuid) {
  const std::regex line_of_head(uuid + " [0-9]{1,18} [0-9a-f]{64}");
  for (std::size_t at = bytes.find(uuid); at != std::string_view::npos;
       at = bytes.find(uuid, at + 1)) {
    if (!std::regex_search(bytes.begin() + at, bytes.end(), line_of_head,
                           std::regex_constants::match_continuous)) {
      return true;
    }
  }
  return false;
}

/// code: empty if only UUIDs count.
std::optional<std::string> found_in(std::string_view bytes, const std::string& code,
                                    const std::set<std::string>& uuids) {
  if (std::ranges::any_of(uuids, [&](const std::string& uuid) { return has_uuid(bytes, uuid); })) {
    return "holds the session's UUID";
  }
  constexpr std::size_t never_by_chance = 6;
  const bool may_tell = code.size() >= never_by_chance || is_text(bytes);
  return !code.empty() && may_tell && has_word(bytes, code)
             ? std::optional<std::string>("holds the code " + code)
             : std::nullopt;
}

/// In portions that overlap by more than a code or a UUID is long.
std::optional<std::string> found_in(const fs::path& path, const std::string& code,
                                    const std::set<std::string>& uuids) {
  constexpr std::size_t portion = std::size_t{1} << 22;
  constexpr std::size_t overlap = 1024;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return "cannot be read";
  }
  std::string bytes;
  bool is_database = false;
  while (file) {
    bytes.erase(0, bytes.size() - std::min(bytes.size(), overlap));
    const std::size_t kept = bytes.size();
    bytes.resize(kept + portion);
    file.read(bytes.data() + kept, portion);
    bytes.resize(kept + static_cast<std::size_t>(file.gcount()));
    is_database = is_database || bytes.starts_with("SQLite format 3");
    // In another study, the code is another person's.
    if (std::optional<std::string> found =
            found_in(std::string_view(bytes), is_database ? "" : code, uuids)) {
      return found;
    }
  }
  return file.eof() ? std::nullopt : std::optional<std::string>("cannot be read");
}

}  // namespace

bool has_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_of_word(text[at - 1])) && (end == text.size() || !is_of_word(text[end]))) {
      return true;
    }
  }
  return false;
}

std::vector<RemainingCopy> remaining_copies(const fs::path& study, const std::string& code,
                                            const std::set<std::string>& uuids) {
  std::vector<RemainingCopy> copies;
  const fs::path folder = study.has_parent_path() ? study.parent_path() : fs::path(".");
  std::error_code failure;
  fs::recursive_directory_iterator entry(folder, failure);
  for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
    std::error_code ignored;
    if (entry->is_directory(ignored) && !entry->is_symlink(ignored)) {
      fs::directory_iterator(entry->path(), ignored);
      if (ignored) {
        copies.push_back({entry->path(), "cannot be read"});
        entry.disable_recursion_pending();
      }
      continue;
    }
    if (!entry->is_regular_file(ignored) || entry->is_symlink(ignored)) {
      continue;
    }
    if (has_word(entry->path().lexically_relative(folder).string(), code)) {
      copies.push_back({entry->path(), "is named after " + code});
    } else if (std::optional<std::string> found = found_in(entry->path(), code, uuids)) {
      copies.push_back({entry->path(), std::move(*found)});
    }
  }
  std::ranges::sort(copies, {}, &RemainingCopy::file);
  return copies;
}

}  // namespace foveola::study
