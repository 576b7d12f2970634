// Reads text files of one statement per line, as OBJ and MTL are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "renderer/base/work/work_scope.h"

namespace foveola {

/// The content of a file. Throws Error if it cannot be read or is larger than `largest` bytes.
std::string read_bytes(const std::filesystem::path& path, std::size_t largest);

/// The text in `bytes`, the content of the file at `path`: UTF-8, whose byte order mark becomes
/// blank, or UTF-16 with a byte order mark. Throws Error if it is truncated UTF-16 or holds a zero
/// byte.
std::string utf8_text(const std::filesystem::path& path, std::string bytes);

/// Without surrounding spaces and tabs.
std::string_view trimmed(std::string_view text);

/// The first word of a line, and the rest.
struct Statement {
  std::string_view keyword;
  std::string_view rest;  ///< trimmed
};
Statement statement_in(std::string_view line);

/// Whether the whole `word` is a decimal number that tinyobjloader can read.
bool is_number(std::string_view word);

/// Calls `use` with each line of `text`, ended by LF, CR LF, CR or the end of the text. Throws
/// WorkStopped in stopped work.
template <typename Use>
void for_each_line(std::string_view text, Use use) {
  while (!text.empty()) {
    throw_if_work_stopped();
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    use(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace foveola
