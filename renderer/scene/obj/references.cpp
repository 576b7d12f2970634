#include "renderer/scene/obj/references.h"

#include <string>

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

}  // namespace

std::optional<fs::path> find_obj_reference(const fs::path& folder, std::string_view name) {
  return confined_file_if_there(folder, as_uri(std::string(trimmed(name))));
}

}  // namespace foveola
