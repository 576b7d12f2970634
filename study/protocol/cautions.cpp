#include "study/protocol/cautions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "study/protocol/protocol_places.h"
#include "study/protocol/untranslated.h"

namespace fs = std::filesystem;

namespace foveola::study {
namespace {

using Directions = std::vector<float>;

/// Returns a method's sampling directions for two views and gazes: equal for two methods only if
/// they are the same.
Directions directions_of(const Protocol& protocol, const std::string& method) {
  constexpr std::size_t samples = 256;
  std::vector<Vec2> points;
  for (std::size_t i = 0; i < samples; ++i) {
    constexpr double golden_ratio = 0.6180339887498949;
    const double x = (static_cast<double>(i) + 0.5) / samples;
    const double y = static_cast<double>(i) * golden_ratio;
    points.emplace_back(x, y - std::floor(y));
  }
  const std::unique_ptr<ViewSampler> sampler = make_sampler(protocol, method);
  const FieldOfView field_of_view{.horizontal_deg = protocol.display.horizontal_fov_deg,
                                  .vertical_deg = protocol.display.vertical_fov_deg,
                                  .lens = protocol.display.lens};
  Directions directions;
  for (const AzimuthElevation& heading :
       {AzimuthElevation{}, AzimuthElevation{.azimuth_rad = 1.0, .elevation_rad = 0.25}}) {
    const AzimuthElevation gaze{.azimuth_rad = heading.azimuth_rad + 0.2,
                                .elevation_rad = heading.elevation_rad - 0.1};
    sampler->aim({.viewport = Viewport(heading, field_of_view),
                  .gaze = direction_from(gaze),
                  .pointer = std::nullopt});
    std::vector<ViewSample> taken(samples);
    sampler->sample(points, taken);
    for (const ViewSample& sample : taken) {
      directions.insert(directions.end(),
                        {sample.direction.x, sample.direction.y, sample.direction.z});
    }
  }
  return directions;
}

bool have_same_settings(const Protocol& protocol, const std::string& a, const std::string& b) {
  return std::ranges::all_of(protocol.scenes, [&](const SceneEntry& scene) {
    return settings_of(protocol, scene.name, a) == settings_of(protocol, scene.name, b);
  });
}

void add_same_methods(const Protocol& protocol, const ProtocolPlaces& places,
                      std::vector<std::string>& warnings) {
  std::map<Directions, std::vector<std::string>> methods_at;
  for (std::size_t i = 0; i < protocol.methods.size(); ++i) {
    const std::string& method = protocol.methods[i];
    std::vector<std::string>& others = methods_at[directions_of(protocol, method)];
    const auto same = std::ranges::find_if(others, [&](const std::string& other) {
      return have_same_settings(protocol, method, other);
    });
    if (same != others.end()) {
      warnings.emplace_back(
          Error(
              places.of(fmt::format("methods[{}]", i)),
              fmt::format("'{}' is the same method as '{}', with the same settings", method, *same),
              "remove one of them, unless a method is to be compared with itself")
              .what());
    }
    others.push_back(method);
  }
}

void add_method_notes(const Protocol& protocol, const ProtocolPlaces& places,
                      std::vector<std::string>& warnings) {
  for (std::size_t i = 0; i < protocol.methods.size(); ++i) {
    for (const std::string& note : method_notes(protocol.methods[i])) {
      warnings.emplace_back(
          Error(places.of(fmt::format("methods[{}]", i)), note, "write shares that add up to 1")
              .what());
    }
  }
}

/// Returns the facts that distinguish a scene's pictures: its file and its viewpoint.
auto view_of(const SceneSource& scene) {
  std::error_code ignored;
  const fs::path file = fs::weakly_canonical(scene.file, ignored);
  const Vec3 position = scene.camera_position.value_or(Vec3(0.0F));
  return std::tuple(file, position.x, position.y, position.z, scene.heading.azimuth_rad,
                    scene.heading.elevation_rad);
}

void add_same_scenes(const Protocol& protocol, const std::vector<SceneSource>& scenes,
                     std::vector<std::string>& warnings) {
  std::map<decltype(view_of(scenes.front())), std::string> names;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const SceneEntry& entry = protocol.scenes[i];
    const auto [known, is_new] = names.emplace(view_of(scenes[i]), entry.name);
    if (!is_new) {
      warnings.emplace_back(
          Error(fmt::format("{}:{}:{}", protocol.path.string(), entry.line, entry.column),
                fmt::format("the scene '{}' is '{}' under another name: the same view of the "
                            "file {}",
                            entry.name, known->second, scenes[i].file.string()),
                "remove one of them, unless participants are to see it twice")
              .what());
    }
  }
}

/// A study's exposure is never automatic, as that would change with every look.
void add_unsaid_exposures(const Protocol& protocol, const std::vector<SceneSource>& scenes,
                          std::vector<std::string>& warnings) {
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const SceneEntry& entry = protocol.scenes[i];
    if (!scenes[i].exposure_stops) {
      warnings.emplace_back(
          Error(fmt::format("{}:{}:{}", protocol.path.string(), entry.line, entry.column),
                fmt::format("the scene '{}' has no exposure: it is shown at 0 stops", entry.name),
                "write exposure_stops into its descriptor, as foveola scene describe does")
              .what());
    }
  }
}

void add_few_scenes(const Protocol& protocol, const ProtocolPlaces& places,
                    std::vector<std::string>& warnings) {
  const bool are_random = protocol.analysis.scenes == SceneEffects::random;
  if (are_random && !protocol.analysis.primary.empty() &&
      protocol.scenes.size() < min_random_scenes) {
    warnings.emplace_back(
        Error(
            places.of("analysis"),
            fmt::format(
                "{} too few to generalise to other scenes: a 95 % confidence interval undercovers",
                protocol.scenes.size() == 1 ? std::string("one scene is")
                                            : fmt::format("{} scenes are", protocol.scenes.size())),
            fmt::format("use {} scenes, or limit the results to these: scenes = \"fixed\"",
                        min_random_scenes))
            .what());
  }
}

void add_untranslated(const Protocol& protocol, const ProtocolPlaces& places,
                      std::vector<std::string>& warnings) {
  constexpr std::size_t max_listed = 10;
  const UntranslatedTexts texts = untranslated_texts(protocol);
  if (texts.keys.empty()) {
    return;
  }
  warnings.emplace_back(
      Error(places.of("language"),
            fmt::format("the language is {}, and {} of the {} texts of the screens stay English{}",
                        protocol.language, texts.keys.size(), texts.of,
                        texts.keys.size() <= max_listed
                            ? fmt::format(": {}", fmt::join(texts.keys, ", "))
                            : ""),
            texts.keys.size() <= max_listed
                ? "give the protocol its own words for them"
                : "give the protocol its own words for them; --json lists them as untranslated")
          .what());
}

}  // namespace

std::vector<std::string> cautions(const Protocol& protocol,
                                  const std::vector<SceneSource>& scenes) {
  const ProtocolPlaces places(protocol);
  std::vector<std::string> warnings;
  add_same_methods(protocol, places, warnings);
  add_method_notes(protocol, places, warnings);
  add_same_scenes(protocol, scenes, warnings);
  add_unsaid_exposures(protocol, scenes, warnings);
  add_few_scenes(protocol, places, warnings);
  add_untranslated(protocol, places, warnings);
  return warnings;
}

}  // namespace foveola::study
