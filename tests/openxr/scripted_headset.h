// A headset without a headset, for whatever speaks OpenXR in a test.
#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/scenes/environment.h"
#include "tests/temporary_folder.h"

namespace foveola::test {

/// Makes the test runtime the one that OpenXR's loader loads in this process and in those that it
/// starts, with a script (runtime/script.h) and a log (runtime/log.h).
class ScriptedHeadset {
 public:
  /// Whether the validation layer of OpenXR's loader looks at what the application calls. It keeps
  /// some of what is wrong from the runtime.
  enum class Validation { on, off };

  /// script: in JSON. The environment is restored at the end.
  explicit ScriptedHeadset(const std::string& script = "{}",
                           Validation validation = Validation::on);

  /// Another script, for the next instance.
  void play(const std::string& script) const;

  /// The whole lines of a kind that the log has so far.
  std::vector<nlohmann::json> log(const std::string& kind) const;

  /// The last of them, of which there is one.
  nlohmann::json newest_log(const std::string& kind) const;

  /// What the validation layer found wrong: nothing, if all is well.
  std::string found_invalid() const;

  /// The pictures of the frames that were to be saved: portable pixmaps by their names, as
  /// 12-0.ppm.
  std::map<std::string, std::string> pictures() const;

  /// The file of a saved frame's picture for eye 0 or 1, complete once the log has the frame.
  std::filesystem::path picture_file(std::int64_t frame, int eye) const;

 private:
  std::vector<std::string> log_lines(const std::string& kind) const;

  TemporaryFolder folder_;
  TemporaryFolder pictures_;
  std::list<scenes::EnvironmentVariable> environment_;
};

}  // namespace foveola::test
