#include "tests/end_to_end/hall.h"

#include "renderer/base/files/files.h"
#include "renderer/glb/glb_document.h"

namespace foveola::test {

const char* const small_tables = R"(
[machine]
samples_per_second = 3845

[film]
width = 32
height = 16
max_depth = 2

[display]
view_width = 16
view_height = 16

[reference]
samples_per_pixel = 4
samples_per_object = 100
)";

std::string hall_protocol() {
  return R"(
name = "hall"
title = "A study of a hall"
scenes = ["hall"]
methods = ["od"]

[timing]
mark_timeout_s = 5
)" + std::string(small_tables);
}

std::string questionnaire_table(const std::string& id, const std::vector<std::string>& questions) {
  std::string table = "[[questionnaire]]\nid = \"" + id + "\"\ntitle = \"About you\"\n";
  for (const std::string& question : questions) {
    table += "[[questionnaire.question]]" + question;
  }
  return table;
}

const char* const age_question = R"(
id = "age"
text = "How old are you?"
kind = "number"
minimum = 18
maximum = 99
)";

const char* const hall_descriptor = R"(
title = "A hall"
author = "Somebody"
licence = "CC0"
file = "hall.glb"
exposure_stops = 0.0

[camera]
position = [0.0, 1.0, 0.0]
azimuth_deg = 0.0
elevation_deg = 0.0

[[object]]
name = "Wall"
position = [0.0, 1.0, -1.0]
radius_deg = 5.0
)";

std::string room_glb() { return glb_container(room_gltf(), ""); }

Hall::Hall() {
  folder.write("share/protocols/hall.toml", hall_protocol());
  folder.write("share/scenes/hall.toml", hall_descriptor);
  folder.write(
      "share/data/participants/adults.toml",
      read_file(std::filesystem::path(TEST_DATA_DIR) / "../../data/participants/adults.toml"));
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
