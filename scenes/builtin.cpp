#include "scenes/builtin.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "scenes/modelling/glb_writer.h"

namespace fs = std::filesystem;

namespace foveola::scenes {
namespace {

struct Builtin {
  std::string_view name;
  Model (*make)();
};

constexpr std::array<Builtin, 5> builtins = {{
    {"arcade", make_arcade},
    {"church", make_church},
    {"meeting-room", make_meeting_room},
    {"schoolroom", make_schoolroom},
    {"studio-car", make_studio_car},
}};

}  // namespace

std::vector<std::string> builtin_names() {
  std::vector<std::string> names;
  for (const Builtin& builtin : builtins) {
    names.emplace_back(builtin.name);
  }
  return names;
}

Model make_builtin(const std::string& name) {
  const auto* const found =
      std::find_if(builtins.begin(), builtins.end(),
                   [&](const Builtin& builtin) { return builtin.name == name; });
  if (found == builtins.end()) {
    throw Error(name, "is not a built-in scene",
                fmt::format("those are {}", fmt::join(builtin_names(), ", ")));
  }
  return found->make();
}

fs::path cached_builtin(const std::string& name) {
  return cache_folder() / "scenes" / fmt::format("{}-{}.glb", name, FOVEOLA_GENERATORS_DIGEST);
}

std::size_t write_builtin(const std::string& name, const fs::path& file) {
  const Model model = make_builtin(name);
  std::error_code failure;
  fs::create_directories(file.parent_path(), failure);
  if (failure) {
    throw Error(file.parent_path().string(), "cannot be made: " + failure.message(),
                "choose another folder");
  }
  write_file(file, glb_from(model));
  return model.triangle_count();
}

fs::path require_builtin(const std::string& name) {
  const fs::path file = cached_builtin(name);
  if (!fs::exists(file)) {
    write_builtin(name, file);
  }
  return file;
}

}  // namespace foveola::scenes
