#include "renderer/scene/obj/references.h"

#include <algorithm>
#include <cctype>

#include "renderer/scene/obj/text_lines.h"
#include "renderer/scene/references.h"

namespace foveola {
namespace fs = std::filesystem;
namespace {

/// confined_file takes URIs, where a percent sign begins an escape.
std::string as_uri(const std::string& name) {
  std::string uri;
  for (const char c : name) {
    uri += c == '%' ? "%25" : std::string(1, c);
  }
  return uri;
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
  for (const auto& entry : fs::directory_iterator(folder, failure)) {
    const fs::path other = entry.path().filename();
    if (are_same_but_for_case(other.native(), name.native())) {
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

}  // namespace

std::optional<fs::path> find_obj_reference(const fs::path& folder, std::string_view name) {
  const std::string local = local_reference(trimmed(name));
  if (auto file = confined_file_if_there(folder, as_uri(local))) {
    return file;
  }
  const std::optional<fs::path> other = in_its_own_case(folder, local);
  return other ? std::optional(confined_file(folder, as_uri(other->native()))) : std::nullopt;
}

}  // namespace foveola
