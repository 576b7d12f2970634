#include "renderer/scene/made_up_names.h"

#include <fmt/format.h>

namespace foveola {

std::string made_up_name(std::string_view kind, std::size_t number, std::set<std::string>& taken) {
  std::string name = fmt::format("{} {}", kind, number);
  while (!taken.insert(name).second) {
    name.insert(0, "another ");
  }
  return name;
}

std::vector<std::string> camera_names(const std::vector<CameraView>& cameras) {
  std::set<std::string> taken{""};
  std::vector<std::string> names;
  for (const CameraView& camera : cameras) {
    names.push_back(taken.insert(camera.name).second ? camera.name : "");
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) {
      names[i] = made_up_name("camera", i + 1, taken);
    }
  }
  return names;
}

}  // namespace foveola
