#include "renderer/scene/prepare/made_up_names.h"

#include <utility>

#include <fmt/format.h>

#include "renderer/base/transformed.h"

namespace foveola {

std::string made_up_name(std::string_view kind, std::size_t number, std::set<std::string>& taken) {
  std::string name = fmt::format("{} {}", kind, number);
  while (!taken.insert(name).second) {
    name.insert(0, "another ");
  }
  return name;
}

std::vector<std::string> distinct_names(std::vector<std::string> names, std::string_view kind) {
  std::set<std::string> taken{""};
  for (std::string& name : names) {
    if (!taken.insert(name).second) {
      name.clear();
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) {
      names[i] = made_up_name(kind, i + 1, taken);
    }
  }
  return names;
}

std::vector<std::string> camera_names(const std::vector<CameraView>& cameras) {
  std::vector<std::string> names = transformed(cameras, &CameraView::name);
  return distinct_names(std::move(names), "camera");
}

}  // namespace foveola
