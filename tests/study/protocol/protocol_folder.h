// A protocol on a disk, and the shortest text of one, for tests of what a protocol may say.
#pragma once

#include <filesystem>
#include <string>

#include "renderer/base/error.h"
#include "study/protocol/protocol.h"
#include "tests/matchers.h"
#include "tests/temporary_folder.h"

namespace foveola::study {

namespace fs = std::filesystem;

// What these tests say of messages.

/// A minimal protocol that tables can be added to; its four keys end at line 4.
inline const std::string minimal = R"(name = "small"
title = "A small one"
scenes = ["arcade", "room"]
methods = ["od", "fv"]
)";

/// A folder with a protocol, p.toml, and whatever lies beside it.
class ProtocolFolder : public testing::Test {
 protected:
  Protocol load(const std::string& text) const {
    folder_.write("p.toml", text);
    return load_protocol(path_);
  }

  test::TemporaryFolder folder_;
  const fs::path path_ = folder_ / "p.toml";
};

/// Loads the minimal protocol with more tables.
class ProtocolTables : public ProtocolFolder {
 protected:
  Protocol load(const std::string& tables) const { return ProtocolFolder::load(minimal + tables); }
};

}  // namespace foveola::study
