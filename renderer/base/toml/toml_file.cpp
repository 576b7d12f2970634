#include "renderer/base/toml/toml_file.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"

namespace fs = std::filesystem;

namespace foveola {
namespace {

/// "FILE:LINE:COLUMN" of the byte at `offset`.
std::string place_of(const std::string& file, std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  return fmt::format("{}:{}:{}", file, std::ranges::count(before, '\n') + 1,
                     offset - line_begin + 1);
}

/// The end of the string whose quotation mark is at `begin`. A single-line string ends with its
/// line at the latest.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  const char mark = text[begin];
  const std::string three(3, mark);
  const bool is_multi_line = text.substr(begin, 3) == three;
  const std::string_view close = is_multi_line ? std::string_view(three) : text.substr(begin, 1);
  for (std::size_t i = begin + close.size(); i < text.size(); ++i) {
    if (mark == '"' && text[i] == '\\') {
      ++i;
    } else if (text.substr(i, close.size()) == close) {
      return i + close.size();
    } else if (!is_multi_line && text[i] == '\n') {
      return i;
    }
  }
  return text.size();
}

/// Each part of a dotted key is a table within a table, like nested inline tables. toml++ reads and
/// destroys them by recursion: deep ones would exhaust the stack. It limits the nesting of values,
/// but neither the parts of a key nor both together.
void require_shallow(const std::string& file, std::string_view text, const std::string& remedy) {
  constexpr std::size_t max_parts = 16;
  constexpr int deepest_nesting = 16;
  std::size_t parts = 1;
  int nesting = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char letter = text[i];
    if (letter == '"' || letter == '\'') {
      i = end_of_string(text, i);
      continue;
    }
    if (letter == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (letter == '.' && ++parts > max_parts) {
      throw Error(place_of(file, text, i), fmt::format("a key of over {} parts", max_parts),
                  remedy);
    }
    if ((letter == '[' || letter == '{') && ++nesting > deepest_nesting) {
      throw Error(place_of(file, text, i),
                  fmt::format("lists or tables nested over {} deep", deepest_nesting), remedy);
    }
    if (letter == ']' || letter == '}') {
      --nesting;
    }
    if (std::string_view("=,[]{}\n").find(letter) != std::string_view::npos) {
      parts = 1;
    }
    ++i;
  }
}

constexpr std::size_t max_bytes = 4'000'000;

void require_moderate_size(const std::string& file, std::string_view text,
                           const std::string& remedy) {
  if (text.size() > max_bytes) {
    throw Error(file, fmt::format("has over {} bytes, the maximum that is read", max_bytes),
                remedy);
  }
}

}  // namespace

std::string read_toml_file(const fs::path& path) {
  return read_file(path, max_bytes, "name a TOML file");
}

toml::table parse_toml(const std::string& file, const std::string& text,
                       const std::string& remedy) {
  require_moderate_size(file, text, remedy);
  require_shallow(file, text, remedy);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw Error(place_of(file, error.source()), std::string(error.description()), remedy);
  }
}

std::vector<std::string> toml_names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code failure;
  fs::directory_iterator entry(folder, failure);
  for (; !failure && entry != fs::directory_iterator(); entry.increment(failure)) {
    if (entry->path().extension() == ".toml") {
      names.push_back(entry->path().stem().string());
    }
  }
  if (failure) {
    throw Error(folder.string(), "cannot be read: " + failure.message(),
                "install Foveola again, or set FOVEOLA_RESOURCES to the folder that holds "
                "protocols/, scenes/ and data/");
  }
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> toml_names_or_none(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(folder, ignored) ? toml_names_in(folder) : std::vector<std::string>();
}

std::string place_of(const std::string& file, const toml::source_region& source) {
  return fmt::format("{}:{}:{}", file, source.begin.line, source.begin.column);
}

}  // namespace foveola
