#include "renderer/command_line/common_options.h"

#include <CLI/CLI.hpp>

namespace foveola {

void add_scene_option(CLI::App& command, std::string& scene) {
  command.add_option("SCENE", scene, "A scene's name, or a .glb, .gltf or .obj file")->required();
}

void add_max_depth_option(CLI::App& command, int& max_depth) {
  command
      .add_option("--max-depth", max_depth,
                  "Maximum number of surface vertices of a path; 1 is direct light only")
      ->check(CLI::Range(1, 1 << 20));
}

void add_threads_option(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "Number of threads; 0: one for each core")
      ->check(CLI::Range(0, 1024));
}

void add_json_option(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "Print the result as JSON");
}

}  // namespace foveola
