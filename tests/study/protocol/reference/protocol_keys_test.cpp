// Whether the table of keys says what the readers do.
#include "study/protocol/reference/protocol_keys.h"

#include <algorithm>
#include <string>

#include "renderer/base/files/files.h"
#include "study/protocol/protocol.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

const std::vector<DescribedTable>& tables() {
  static const std::vector<DescribedTable> all = described_tables();
  return all;
}

const DescribedTable& table_of(const std::string& file, const std::string& name) {
  const auto found = std::find_if(tables().begin(), tables().end(), [&](const auto& table) {
    return table.file == file && table.name == name;
  });
  if (found == tables().end()) {
    throw std::runtime_error("there is no table " + name + " of a " + file);
  }
  return *found;
}

const TomlKey& rule_of(const std::string& table, const std::string& key) {
  const std::vector<TomlKey>& keys = table_of("protocol", table).keys;
  const auto found = std::ranges::find(keys, key, &TomlKey::key);
  if (found == keys.end()) {
    throw std::runtime_error("there is no key " + key);
  }
  return *found;
}

TEST(ProtocolKeys, SayWhatTheReadersDo) {
  const TomlKey& timeout = rule_of("timing", "mark_timeout_s");
  EXPECT_THAT(timeout.types, ElementsAre("number"));
  EXPECT_EQ(timeout.minimum, 0.1);
  EXPECT_EQ(timeout.maximum, 3600.0);
  EXPECT_EQ(timeout.default_text, "120");
  EXPECT_FALSE(timeout.is_required);
  EXPECT_TRUE(rule_of("", "scenes").is_required);
  EXPECT_THAT(rule_of("", "scene_order").words,
              ElementsAre("fixed", "random", "latin", "williams"));
  EXPECT_THAT(rule_of("tracker.validation", "points").words, ElementsAre("5", "9"));
  EXPECT_THAT(rule_of("display", "fov_deg").types, ElementsAre("number", "list of 2 numbers"));
  EXPECT_EQ(rule_of("film", "adaptive_contrast").former, "spare_done_contrast");
  EXPECT_EQ(rule_of("rating", "minimum").default_text, "1");
  EXPECT_FALSE(rule_of("rating", "minimum").is_required) << "only of a number";
  EXPECT_TRUE(rule_of("mark", "simulated").default_varies) << "with the mark's id";
  EXPECT_EQ(rule_of("preflight", "min_free_gb").default_text, std::nullopt);
}

TEST(ProtocolKeys, EquivalenceMarginsAreByTheStudysIds) {
  const DescribedTable& margins = table_of("protocol", "analysis.equivalence_margins");
  EXPECT_TRUE(margins.is_keyed_by_ids);
  ASSERT_EQ(margins.keys.size(), 3U);
  EXPECT_EQ(margins.keys[0].key, "outline");
  EXPECT_EQ(margins.keys[2].maximum, 4.0) << "the published rating goes from 1 to 5";
}

/// The built-in words of screens need no explanation.
TEST(ProtocolKeys, AllHaveAMeaning) {
  for (const DescribedTable& table : tables()) {
    EXPECT_THAT(table.meaning, Not(IsEmpty())) << table.file << " " << table.name;
    for (const TomlKey& key : table.keys) {
      if (table.name != "texts" && !table.is_keyed_by_ids) {
        EXPECT_THAT(key.meaning, Not(IsEmpty()))
            << table.file << " " << table.name << "." << key.key;
      }
    }
  }
}

/// What comes with the program is in no example, so a key that no example leads to is found here.
TEST(ProtocolKeys, ThereAreNoOthersInTheFilesOfTheProgram) {
  TomlKeys asked;
  for (const char* name : {"koskela2018", "koskela2018-original", "demo"}) {
    const std::filesystem::path path = find_protocol(name);
    read_protocol(read_file(path), path, &asked);
  }
  for (const TomlKey& key : asked.keys()) {
    const DescribedTable& table = table_of("protocol", key.table);
    if (!table.is_keyed_by_ids) {
      EXPECT_THAT(table.keys, Contains(testing::Field(&TomlKey::key, key.key)));
    }
  }
}

}  // namespace
}  // namespace foveola::study
