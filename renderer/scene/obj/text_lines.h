// Text files of one statement a line, as OBJ and MTL are.
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

/// The text in `bytes`, the content of the file at `path`: in UTF-8, whose byte order mark becomes
/// blank, or, by its byte order mark, in UTF-16 of either order. Throws Error if it is UTF-16 that
/// is cut off, or holds a zero, which no text does.
std::string utf8_text(const std::filesystem::path& path, std::string bytes);

/// Without blanks (spaces and tabs) on either side.
std::string_view trimmed(std::string_view text);

/// The first word of a line, and the rest.
struct Statement {
  std::string_view keyword;
  std::string_view rest;  ///< trimmed
};
Statement statement_in(std::string_view line);

/// Whether `word` is a decimal number, which tinyobjloader can read, from its first character to
/// its last.
bool is_number(std::string_view word);

/// Calls `use` with each line of `text`, whether LF, CR LF, CR or the text ends it. Throws
/// WorkStopped in work that is stopped.
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
