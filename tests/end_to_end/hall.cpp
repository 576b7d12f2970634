#include "tests/end_to_end/hall.h"

#include <cstdint>
#include <cstring>

namespace foveola::test {

const char* const hall_protocol = R"(
name = "hall"
title = "A study of a hall"
scenes = ["hall"]
methods = ["od"]

[machine]
samples_per_second = 3845

[film]
width = 32
height = 16
max_depth = 2

[display]
view_width = 16
view_height = 16

[timing]
mark_timeout_s = 5

[reference]
samples_per_pixel = 4
samples_per_object = 100
)";

const char* const hall_descriptor = R"(
title = "A hall"
author = "Somebody"
licence = "CC0"
file = "hall.glb"

[camera]
position = [0.0, 1.0, 0.0]
azimuth_deg = 0.0
elevation_deg = 0.0

[[object]]
name = "Wall"
position = [0.0, 1.0, -1.0]
radius_deg = 5.0
)";

/// room_gltf() as a .glb of its JSON alone.
std::string room_glb() {
  std::string json = room_gltf();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto word = [](std::size_t value) {
    const auto bits = static_cast<std::uint32_t>(value);
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &bits, 4);
    return bytes;
  };
  return "glTF" + word(2) + word(20 + json.size()) + word(json.size()) + "JSON" + json;
}

Hall::Hall() {
  folder.write("share/protocols/hall.toml", hall_protocol);
  folder.write("share/scenes/hall.toml", hall_descriptor);
  folder.write("real/hall.glb", room_glb());
}

Environment Hall::environment() const {
  return {{"FOVEOLA_RESOURCES", (folder / "share").string()},
          {"FOVEOLA_SCENE_PATH", (folder / "real").string()},
          {"XDG_CACHE_HOME", (folder / "cache").string()}};
}

ProgramResult Hall::run(const std::vector<std::string>& arguments) const {
  return run_foveola(arguments, environment());
}

}  // namespace foveola::test
