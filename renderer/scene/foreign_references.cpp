#include "renderer/scene/foreign_references.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "renderer/scene/sanitised.h"

namespace foveola {
namespace {

std::string with_slashes(std::string_view name) {
  std::string path(name);
  std::replace(path.begin(), path.end(), '\\', '/');
  return path;
}

bool is_letter(char character) { return std::isalpha(static_cast<unsigned char>(character)) != 0; }

}  // namespace

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
