// A study of the hall, whose descriptor names the hash of its file.
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/end_to_end/hall.h"

namespace foveola::test {

class StudyOfAHall : public testing::Test, protected Hall {
 protected:
  StudyOfAHall() {
    digest = run_program({"sha256sum", (folder / "real/hall.glb").string()}).output.substr(0, 64);
    const std::string top = "sha256 = \"" + digest + "\"\n";
    folder.write("share/scenes/hall.toml", top + hall_descriptor);
  }

  ProgramResult simulate(const std::string& database) const {
    return run(
        {"study", "simulate", "hall", "--db", (folder / database).string(), "--participants", "1"});
  }

  void copy_published_numbers() const {
    std::filesystem::copy(std::filesystem::path(TEST_DATA_DIR) / "../../data/koskela2018",
                          folder / "share/data/koskela2018",
                          std::filesystem::copy_options::recursive);
  }

  std::string digest;  ///< hash of hall.glb, by coreutils
};

}  // namespace foveola::test
