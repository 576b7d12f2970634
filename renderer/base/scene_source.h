// A scene as people name it: a file, where to stand in it, and what to add to it.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "renderer/base/angles.h"

namespace foveola {

/// A one-sided rectangular light, for scenes that come without any. It shines towards `normal`,
/// which must be one of the axes +-X, +-Y, +-Z.
struct RectangleLight {
  Vec3 center{0.0F};
  Vec2 size{1.0F};  ///< metres, along the two axes other than the normal's, in the order x, y, z
  Vec3 normal{0.0F, -1.0F, 0.0F};
  Rgb radiance{1.0F};
};

/// Something in the scene that a participant may choose to look at.
struct ObjectOfInterest {
  std::string name;
  Vec3 position{0.0F};      ///< world, metres; its direction is seen from the camera
  float radius_deg = 4.0F;  ///< angular radius that covers it, seen from the camera
};

struct SceneSource {
  std::string name;  ///< what the user called it
  std::string title;
  std::filesystem::path file;  ///< .glb or .gltf
  std::optional<Vec3> camera_position;
  AzimuthElevation heading;
  double exposure_stops = 0.0;
  std::optional<Rgb> environment_radiance;  ///< constant; replaces the file's
  std::vector<RectangleLight> lights;
  std::vector<ObjectOfInterest> objects;
};

/// Finds a scene by name or path: a name of a descriptor (made now if it is a built-in one that is
/// not yet in the cache), else the path of a scene file. Throws Error if it is neither.
using SceneFinder = std::function<SceneSource(const std::string& name_or_path)>;

}  // namespace foveola
