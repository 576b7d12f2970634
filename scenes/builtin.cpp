#include "scenes/builtin.h"

#include <algorithm>

#include "renderer/base/files/files.h"

namespace fs = std::filesystem;

namespace foveola::scenes {

std::vector<std::string> builtin_names() {
  return {"arcade", "church", "meeting-room", "schoolroom", "studio-car"};
}

bool is_builtin_name(const std::string& name) {
  const std::vector<std::string> names = builtin_names();
  return std::ranges::find(names, name) != names.end();
}

fs::path builtin_folder(const std::string& name) { return resource_folder() / "scenes" / name; }

fs::path builtin_file(const std::string& name) { return builtin_folder(name) / (name + ".glb"); }

}  // namespace foveola::scenes
