#include "scenes/builtin.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"

namespace foveola::scenes {
namespace {

struct Builtin {
  std::string_view name;
  Model (*make)(std::uint32_t seed);
};

constexpr std::array<Builtin, 5> builtins = {{
    {"arcade", make_arcade},
    {"church", make_church},
    {"meeting-room", make_meeting_room},
    {"schoolroom", make_schoolroom},
    {"studio-car", make_studio_car},
}};

std::vector<std::string_view> known_names() {
  std::vector<std::string_view> names;
  for (const Builtin& builtin : builtins) {
    names.push_back(builtin.name);
  }
  return names;
}

}  // namespace

Model make_builtin(const std::string& name, std::uint32_t seed) {
  const auto* const found =
      std::find_if(builtins.begin(), builtins.end(),
                   [&](const Builtin& builtin) { return builtin.name == name; });
  if (found == builtins.end()) {
    throw Error(name, "is not a built-in scene",
                fmt::format("those are {}", fmt::join(known_names(), ", ")));
  }
  return found->make(seed);
}

}  // namespace foveola::scenes
