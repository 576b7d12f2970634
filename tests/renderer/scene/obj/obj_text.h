// A fixture that loads OBJ files from their text.
#pragma once

#include <string>

#include "renderer/scene/load_scene.h"
#include "tests/error_of.h"
#include "tests/renderer/scene/glb_builder.h"

namespace foveola::test {

inline const std::string three_corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
/// With texture coordinates, in the material m; behind three_corners.
inline const std::string textured_face = "vt 0 0\nvt 1 0\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3\n";

class ObjText : public InTemporaryFolder {
 protected:
  Scene load(const std::string& obj) const { return load_obj(write("scene.obj", obj)); }

  std::string error_of(const std::string& obj, const SceneReading& reading = {}) const {
    return test::error_of([&] { load_obj(write("scene.obj", obj), reading); });
  }
  std::string strict_error_of(const std::string& obj) const {
    return error_of(obj, {.strict = true});
  }
};

}  // namespace foveola::test
