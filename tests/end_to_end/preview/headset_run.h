// A person's session in a headset.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "renderer/base/files/files.h"
#include "tests/end_to_end/run/study_run.h"

namespace foveola::test {

class HeadsetRun : public StudyRun {
 protected:
  HeadsetRun() {
    for (const char* const profile : {"displays/openxr.toml", "trackers/openxr.toml"}) {
      const std::string data = std::string("data/") + profile;
      participant_.folder().write("share/" + data,
                                  read_file(std::string(TEST_DATA_DIR "/../../") + data));
    }
  }

  nlohmann::json devices() const {
    return nlohmann::json::parse(participant_.ask("SELECT devices FROM session").front());
  }

  std::vector<std::string> notes() const { return participant_.ask("SELECT text FROM note"); }
};

}  // namespace foveola::test
