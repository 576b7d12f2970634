#include "renderer/commands/headset_option.h"

#include <CLI/CLI.hpp>

namespace foveola {

void add_headset_option(CLI::App& command, std::string& display, std::string& tracker) {
  const CLI::Option* const tracker_option = command.get_option("--tracker");
  command
      .add_flag_callback(
          "--headset",
          [&display, &tracker, tracker_option] {
            display = "openxr";
            tracker = tracker_option->empty() ? "openxr" : tracker;
          },
          "Show it in a headset, by OpenXR, as its wearer's head and eyes move; the window shows "
          "what the left eye sees")
      ->excludes(command.get_option("--display"));
}

}  // namespace foveola
