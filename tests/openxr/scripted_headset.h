// A headset without a headset, for a program that speaks OpenXR.
#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/scenes/environment.h"
#include "tests/temporary_folder.h"

namespace foveola::test {

/// Makes the test runtime the one that OpenXR's loader loads in this process and in those that it
/// starts, with a script (runtime/script.h).
class ScriptedHeadset {
 public:
  /// Whether the validation layer of OpenXR's loader looks at what the application calls.
  enum class Validation { on, off };

  /// script: in JSON. The environment is restored at the end.
  explicit ScriptedHeadset(const std::string& script = "{}",
                           Validation validation = Validation::on);

  /// The frames that were ended so far, each with its number "frame" (-1 before the first focus)
  /// and the "orientations" (x, y, z, w) of its views, of which it has two or none.
  std::vector<nlohmann::json> frames() const;
  /// The number of the last of them, of which there is one.
  std::int64_t newest_frame() const;

  /// What the validation layer and the runtime found wrong: nothing, if all is well.
  std::string found_invalid() const;

  /// The file of a saved frame's picture for eye 0 or 1, complete once the frame was ended.
  std::filesystem::path picture_file(std::int64_t frame, int eye) const;

 private:
  std::vector<std::string> log_lines(const std::string& kind) const;

  TemporaryFolder folder_;
  std::list<scenes::EnvironmentVariable> environment_;
};

}  // namespace foveola::test
