#include "study/protocol/reading/read_overrides.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "study/protocol/reading/read_settings.h"

namespace foveola::study {
namespace {

/// The scope of an [[override]], and its settings.
struct Override {
  std::string scene;   ///< Empty for all scenes.
  std::string method;  ///< Empty for all methods.
  TomlReader reader;

  bool holds_for(const std::string& a_scene, const std::string& a_method) const {
    return (scene.empty() || scene == a_scene) && (method.empty() || method == a_method);
  }
  /// Order of application: the scene's first, then the method's, then those of both.
  int rank() const { return (scene.empty() ? 0 : 1) + (method.empty() ? 0 : 2); }
};

Override read_place(TomlReader reader, const Protocol& protocol) {
  const std::string scene =
      read_scene_name(reader, "scene", protocol, "One of the protocol's scenes.");
  const std::string method =
      read_method_name(reader, "method", protocol, "One of the protocol's methods.");
  if (scene.empty() && method.empty()) {
    reader.fail(reader.source(), "the override has neither a scene nor a method",
                "add a scene, a method or both");
  }
  return {scene, method, std::move(reader)};
}

std::vector<Override> read_places(TomlReader& reader, const Protocol& protocol) {
  std::vector<Override> overrides;
  for (const TomlReader& entry : reader.tables(
           "override",
           "Settings of one scene, of one method, or of both: a scene's override applies first, "
           "then a method's, then that of both, each only for the keys that it has.")) {
    Override next = read_place(entry, protocol);
    if (std::ranges::any_of(overrides, [&](const Override& other) {
          return other.scene == next.scene && other.method == next.method;
        })) {
      entry.fail(entry.source(), "another override has the same scope", "put both into one");
    }
    overrides.push_back(std::move(next));
  }
  std::ranges::stable_sort(
      overrides, [](const Override& a, const Override& b) { return a.rank() < b.rank(); });
  return overrides;
}

/// Returns the settings with the override's keys replaced.
TrialSettings overridden(TomlReader& reader, TrialSettings settings) {
  settings.film =
      read_film(reader.table("film", "The film: the 360-degree image that samples are summed in."),
                settings.film);
  settings.timing = read_timing(reader.table("timing", "Time-outs and times."), settings.timing);
  reader.read("fill_unsampled", settings.fill_unsampled,
              "Whether unsampled pixels are filled. Default: as in `[display]`.");
  reader.reject_unknown_keys();
  return settings;
}

}  // namespace

void read_overrides(TomlReader& reader, Protocol& protocol) {
  for (Override& entry : read_places(reader, protocol)) {
    for (const SceneEntry& scene : protocol.scenes) {
      for (const std::string& method : protocol.methods) {
        if (entry.holds_for(scene.name, method)) {
          protocol.cells[{scene.name, method}] =
              overridden(entry.reader, settings_of(protocol, scene.name, method));
        }
      }
    }
  }
}

}  // namespace foveola::study
