#include "renderer/scene/references.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <stdexcept>

#include <fmt/format.h>

#include "renderer/base/files/file_access.h"
#include "renderer/scene/sanitised.h"

namespace foveola {
namespace fs = std::filesystem;
namespace {

std::string with_slashes(std::string_view name) {
  std::string path(name);
  std::ranges::replace(path, '\\', '/');
  return path;
}

bool is_letter(char character) { return std::isalpha(static_cast<unsigned char>(character)) != 0; }

/// RFC 3986, section 3.1: a letter, then letters, digits, "+", "-" and ".", up to a colon. Paths of
/// another machine are handled elsewhere.
bool has_other_scheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  if (colon == std::string_view::npos || colon == 0 || is_foreign_reference(uri)) {
    return false;
  }
  const std::string_view scheme = uri.substr(0, colon);
  return std::isalpha(static_cast<unsigned char>(scheme.front())) != 0 &&
         std::ranges::all_of(scheme, [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '+' || c == '-' || c == '.';
         });
}

}  // namespace

std::string percent_decoded(std::string_view uri) {
  std::string decoded;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char byte = 0;
    const char* digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() &&
        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      decoded += static_cast<char>(byte);
      i += 2;
    } else {
      decoded += uri[i];
    }
  }
  return decoded;
}

fs::path confined_file(const fs::path& folder, std::string_view uri) {
  const std::string name = local_reference(percent_decoded(uri));
  const auto refusal = [&](const std::string& why) {
    return std::runtime_error(fmt::format("refers to \"{}\", {}", sanitised(name), why));
  };
  if (has_other_scheme(uri)) {
    throw refusal("which is not a relative path (only data: and relative references are read)");
  }
  try {
    return confined_path(folder, name);
  } catch (const std::runtime_error& reason) {
    throw refusal(reason.what());
  }
}

std::optional<fs::path> confined_file_if_there(const fs::path& folder, std::string_view uri) {
  const fs::path name = local_reference(percent_decoded(uri));
  const bool stays_inside =
      !has_other_scheme(uri) && std::find(name.begin(), name.end(), "..") == name.end();
  std::error_code failure;
  if (stays_inside && !fs::exists(folder / name, failure)) {
    return std::nullopt;
  }
  return confined_file(folder, uri);
}

bool is_foreign_reference(std::string_view name) {
  const std::string path = with_slashes(name);
  return path.starts_with('/') || path.starts_with("file:") ||
         (path.size() > 1 && is_letter(path[0]) && path[1] == ':');
}

std::string local_reference(std::string_view name) {
  const std::string path = with_slashes(name);
  return is_foreign_reference(path) ? path.substr(path.find_last_of("/:") + 1) : path;
}

void ForeignReferences::add(std::string_view name, Warnings& warnings) {
  if (!is_foreign_reference(name)) {
    return;
  }
  const auto [known, is_new] =
      foreign_by_local_.try_emplace(local_reference(name), with_slashes(name));
  if (!is_new && known->second != with_slashes(name)) {
    warnings.add(fmt::format("{} and a file of the same name in another folder are shown as one, "
                             "the only {} here",
                             sanitised(known->second), sanitised(known->first)),
                 sanitised(std::string(name)));
  }
}

}  // namespace foveola
