// The program foveola-scenes, which makes the built-in scenes: finding it, having it built, and
// running it.
#pragma once

#include <cstdint>
#include <string>

namespace foveola::scenes {

struct GeneratedScene {
  std::size_t triangles = 0;
  std::string glb;  ///< the bytes of the file
};

/// The scene, or with another seed than 0 a variant of it, by the program that was installed beside
/// this one, or built with it. If this one lies in the folder that it was built in, and
/// foveola-scenes is not there or is of other generators, it is built now, and standard error says
/// so; whoever else builds there through this function or the front door waits. Throws Error if
/// there is no such program or it fails.
GeneratedScene generate_scene(const std::string& name, std::uint32_t seed);

}  // namespace foveola::scenes
