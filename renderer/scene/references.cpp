#include "renderer/scene/references.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <stdexcept>

#include <fmt/format.h>

#include "renderer/base/files/file_access.h"
#include "renderer/scene/prepare/sanitised.h"

namespace foveola {
namespace fs = std::filesystem;
namespace {

std::string with_slashes(std::string_view name) {
  std::string path(name);
  std::ranges::replace(path, '\\', '/');
  return path;
}

bool is_letter(char character) { return std::isalpha(static_cast<unsigned char>(character)) != 0; }

/// With slashes, without "." and without ".." that can be resolved.
std::string normalised(std::string_view name) {
  return fs::path(with_slashes(name)).lexically_normal().string();
}

bool is_of_another_machine(std::string_view name) {
  const std::string path = with_slashes(name);
  return path.starts_with('/') || path.starts_with("file:") ||
         (path.size() > 1 && is_letter(path[0]) && path[1] == ':');
}

/// RFC 3986, section 3.1: a letter, then letters, digits, "+", "-" and ".", up to a colon. Paths of
/// another machine are handled elsewhere.
bool has_other_scheme(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  if (colon == std::string_view::npos || colon == 0 || is_of_another_machine(uri)) {
    return false;
  }
  const std::string_view scheme = uri.substr(0, colon);
  return std::isalpha(static_cast<unsigned char>(scheme.front())) != 0 &&
         std::ranges::all_of(scheme, [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '+' || c == '-' || c == '.';
         });
}

bool are_same_but_for_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

/// The entry of `folder` with this name or, without one, the only entry with this name in another
/// case.
std::optional<fs::path> entry_of(const fs::path& folder, const fs::path& name) {
  std::error_code failure;
  if (fs::exists(folder / name, failure)) {
    return name;
  }
  std::optional<fs::path> found;
  if (fs::is_symlink(folder, failure)) {
    return found;
  }
  for (const auto& entry : fs::directory_iterator(folder, failure)) {
    const fs::path other = entry.path().filename();
    if (other != name && are_same_but_for_case(other.native(), name.native())) {
      if (found) {
        return std::nullopt;
      }
      found = other;
    }
  }
  return found;
}

/// `relative` with the actual names of the folders and the file.
std::optional<fs::path> in_its_own_case(const fs::path& folder, const fs::path& relative) {
  fs::path result;
  for (const fs::path& part : relative) {
    const std::optional<fs::path> entry = entry_of(folder / result, part);
    if (!entry) {
      return std::nullopt;
    }
    result /= *entry;
  }
  return result;
}

std::runtime_error refusal(const std::string& name, const std::string& why) {
  return std::runtime_error(fmt::format("refers to \"{}\", {}", sanitised(name), why));
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
  if (const std::optional<fs::path> file = confined_file_if_there(folder, uri)) {
    return *file;
  }
  throw refusal(local_reference(percent_decoded(uri)), "a file that does not exist");
}

std::optional<fs::path> confined_file_if_there(const fs::path& folder, std::string_view uri) {
  const std::string name = local_reference(percent_decoded(uri));
  if (has_other_scheme(uri)) {
    throw refusal(name,
                  "which is not a relative path (only data: and relative references are read)");
  }
  const std::optional<fs::path> relative = in_its_own_case(folder, name);
  if (!relative) {
    return std::nullopt;
  }
  try {
    return confined_path(folder, *relative);
  } catch (const std::runtime_error& reason) {
    throw refusal(name, reason.what());
  }
}

bool is_foreign_reference(std::string_view name) {
  return is_of_another_machine(name) || (normalised(name) + "/").starts_with("../");
}

std::string reference_from(std::string_view subfolder, std::string_view name) {
  return std::string(is_of_another_machine(name) ? "" : subfolder).append(name);
}

std::string local_reference(std::string_view name) {
  const std::string path = normalised(name);
  return is_foreign_reference(name) ? path.substr(path.find_last_of("/:") + 1) : path;
}

void ForeignReferences::add(std::string_view name, Warnings& warnings) {
  const auto [known, is_new] = name_by_local_.try_emplace(local_reference(name), normalised(name));
  if (!is_new && known->second != normalised(name)) {
    warnings.add(fmt::format("{} and a file of the same name in another folder are shown as one, "
                             "the only {} here",
                             sanitised(known->second), sanitised(known->first)),
                 sanitised(std::string(name)));
  }
}

}  // namespace foveola
