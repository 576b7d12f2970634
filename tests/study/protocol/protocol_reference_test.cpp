// docs/PROTOCOL.md is what `foveola study keys` prints.
#include "study/protocol/protocol_reference.h"

#include <filesystem>

#include "renderer/base/files/files.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

namespace fs = std::filesystem;

TEST(ProtocolReference, IsTheOneInTheRepository) {
  const fs::path kept = fs::path(TEST_DATA_DIR) / "../../docs/PROTOCOL.md";
  const std::string reference = protocol_reference();
  if (read_file(kept) != reference) {
    const fs::path made = fs::temp_directory_path() / "foveola-PROTOCOL.md";
    write_file(made, reference);
    FAIL() << "PROTOCOL.md is not what the readers and the schema say; if they changed on "
              "purpose:\n  cp "
           << made.string() << ' ' << kept.lexically_normal().string();
  }
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
