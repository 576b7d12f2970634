// What the application did, for the test to read: a file of JSON, a line for each thing, which
// FOVEOLA_OPENXR_LOG in the environment names.
//
// Every line has a "kind":
//   instance    application, engine, api_version, extensions
//   session     number (from 1 in this process with this script)
//   state       state (as FOCUSED), time_s
//   event       event (as the script names it), time_s
//   swapchain   swapchain (its number from 1), width, height, format, array_size, images
//   frame       xrEndFrame: frame (-1 before the first focus), time_s, predicted_display_time,
//               display_time, should_render, layers: [{type, space, views: [{position_m,
//               orientation (x, y, z, w), fov_deg {left, right, up, down}, swapchain, image,
//               array_index, rect [x, y, width, height]}]}]
//   discarded   frame: xrBeginFrame came for the next one before its xrEndFrame
//   error       function, result, why: a call that was refused, or that the script let fail
//   end         an instance was destroyed
// Times without a unit are XrTime, in ns; time_s is the script's time.
#pragma once

#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

namespace foveola::test::openxr {

class Log {
 public:
  /// Goes on at the file's end. Nothing is written without a file (an empty path).
  void open(const std::filesystem::path& file);
  /// At once, so that what a crash leaves is whole.
  void write(const nlohmann::json& line);

 private:
  std::filesystem::path file_;
  std::ofstream stream_;
};

}  // namespace foveola::test::openxr
