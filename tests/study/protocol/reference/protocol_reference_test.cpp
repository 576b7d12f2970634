// docs/PROTOCOL.md and the schema for editors are what `foveola study keys` prints.
#include "study/protocol/reference/protocol_reference.h"

#include <filesystem>

#include "renderer/base/files/files.h"
#include "study/protocol/reference/protocol_schema.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

namespace fs = std::filesystem;

/// made_by: the command that prints it.
void expect_kept(const std::string& made, const std::string& place, const std::string& made_by) {
  EXPECT_TRUE(read_file(fs::path(TEST_DATA_DIR) / "../.." / place) == made)
      << place << " is not what the readers declare; if they changed on purpose:\n  " << made_by
      << " > " << place;
}

TEST(ProtocolReference, IsTheOneInTheRepository) {
  expect_kept(protocol_reference(), "docs/PROTOCOL.md", "foveola study keys");
}

TEST(ProtocolReference, TheSchemaForEditorsIsTheOneInTheRepository) {
  expect_kept(protocol_schema(), "protocols/foveola-protocol.schema.json",
              "foveola study keys --schema");
}

TEST(ProtocolReference, ItsJsonHasTheKeysWithTheirRanges) {
  const nlohmann::ordered_json tables = protocol_reference_json().at("tables");
  EXPECT_EQ(tables.at(0).at("file"), "protocol");
  EXPECT_EQ(tables.at(0).at("keys").at(0).at("key"), "name");
  bool has_presses = false;
  for (const auto& table : tables) {
    for (const auto& key : table.at("keys")) {
      if (table.at("table") == "reaction" && key.at("key") == "presses") {
        has_presses = true;
        EXPECT_EQ(key.at("minimum"), 1.0);
        EXPECT_EQ(key.at("maximum"), 1000.0);
        EXPECT_EQ(key.at("default"), 10);
      }
    }
  }
  EXPECT_TRUE(has_presses);
}

}  // namespace
}  // namespace foveola::study
