// How a scene was shown, in words that the record keeps.
#pragma once

#include <optional>
#include <string>

#include "renderer/base/scene_source.h"

namespace foveola::study {

/// What `source` says beyond its file, as the JSON object that schema.sql describes at
/// session_scene. The same source has the same text. Throws Error if its environment's file cannot
/// be read.
std::string shown_as(const SceneSource& source);

/// The part of it that changes the radiance of the file's scene: `added`. Throws the same Error.
std::string added_to_file(const SceneSource& source);

/// The direction of an object, unit length, from a viewpoint in the same axes.
Vec3 direction_of(const ObjectOfInterest& object, const Vec3& viewpoint);

/// An object on offer as it is seen from the camera.
struct SeenObject {
  Vec3 direction{0.0F, 0.0F, -1.0F};  ///< unit length, world
  double radius_deg = 4.0;            ///< angular radius that covers it
};

/// The object of this name in a text of shown_as; empty if the text does not say where it or the
/// camera was.
std::optional<SeenObject> object_in(const std::string& shown_as, const std::string& name);

/// Where two texts of shown_as differ first, and what they say there: "camera/azimuth_rad: 0.5, now
/// 0.25". Empty if they mean the same.
std::string difference(const std::string& recorded, const std::string& now);

}  // namespace foveola::study
