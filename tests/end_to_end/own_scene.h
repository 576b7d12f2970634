// A user's own scene, whose descriptor lies beside its file and beside the protocol of a study.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/end_to_end/hall.h"

namespace foveola::test {

class OwnScene : public testing::Test {
 protected:
  OwnScene() {
    write("kitchen.glb", room_glb());
    write("kitchen.toml", descriptor("Stove"));
    write("study.toml",
          "name = \"cooking\"\ntitle = \"A study\"\nscenes = [\"kitchen\"]\n"
          "methods = [\"od\"]\n[timing]\nmark_timeout_s = 5\n" +
              std::string(small_tables));
  }

  static std::string descriptor(const std::string& object) {
    return "title = \"A kitchen\"\nfile = \"kitchen.glb\"\nexposure_stops = 1.5\n"
           "[camera]\nposition = [0, 1, 0]\nazimuth_deg = 0\nelevation_deg = 0\n"
           "[[object]]\nname = \"" +
           object + "\"\nposition = [0, 1, -1]\nradius_deg = 5\n";
  }

  void write(const std::string& name, const std::string& content) {
    folder_.write("mine/" + name, content);
  }
  std::string path(const std::string& name) const { return folder_ / ("mine/" + name); }

  ProgramResult run(const std::vector<std::string>& arguments) const {
    return run_foveola(arguments, {{"XDG_DATA_HOME", (folder_ / "data").string()},
                                   {"XDG_CACHE_HOME", (folder_ / "cache").string()}});
  }

  ProgramResult simulate() const {
    return run({"study", "simulate", path("study.toml"), "--db", path("study.sqlite"),
                "--participants", "1"});
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace foveola::test
