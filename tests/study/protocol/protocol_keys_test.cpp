// Whether what the readers ask for is what the schema for editors says of it.
#include "study/protocol/protocol_keys.h"

#include <algorithm>
#include <map>
#include <string>

#include "study/protocol/schema_tables.h"
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
  const std::vector<DescribedKey>& keys = table_of("protocol", table).keys;
  const auto found = std::find_if(keys.begin(), keys.end(),
                                  [&](const auto& known) { return known.rule.key == key; });
  if (found == keys.end()) {
    throw std::runtime_error("there is no key " + key);
  }
  return found->rule;
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
  EXPECT_EQ(margins.keys[0].rule.key, "outline");
  EXPECT_EQ(margins.keys[2].rule.maximum, 4.0) << "the published rating goes from 1 to 5";
}

/// The built-in words of screens need no explanation.
TEST(ProtocolKeys, AllHaveAMeaning) {
  for (const DescribedTable& table : tables()) {
    EXPECT_THAT(table.meaning, Not(IsEmpty())) << table.file << " " << table.name;
    for (const DescribedKey& key : table.keys) {
      if (table.name != "texts" && !table.is_keyed_by_ids) {
        EXPECT_THAT(key.meaning, Not(IsEmpty()))
            << table.file << " " << table.name << "." << key.rule.key;
      }
    }
  }
}

/// The types in words of those in a property of the schema.
std::vector<std::string> types_in(const SchemaJson& property) {
  if (property.contains("anyOf")) {
    std::vector<std::string> types;
    for (const SchemaJson& choice : property.at("anyOf")) {
      types.push_back(types_in(choice).front());
    }
    return types;
  }
  static const std::map<std::string, std::string> words = {{"string", "text"},
                                                           {"boolean", "true or false"},
                                                           {"integer", "whole number"},
                                                           {"number", "number"},
                                                           {"object", "table"}};
  const std::string type = property.at("type");
  if (type != "array") {
    return {words.at(type)};
  }
  const SchemaJson& items = property.at("items");
  if (items.contains("$ref") || items.at("type") == "object") {
    return {"list of tables"};
  }
  return {items.at("type") == "string" ? "list of texts"
                                       : "list of " + property.at("maxItems").dump() + " numbers"};
}

/// What says the numbers' range: of a list its items, of choices the first.
const SchemaJson& numbers_in(const SchemaJson& property) {
  if (property.contains("anyOf")) {
    return property.at("anyOf").at(0);
  }
  return property.contains("items") ? property.at("items") : property;
}

/// Whether the reader takes `value` in none of the table's examples, so that another rule is
/// stricter than the range.
bool is_refused(const SchemaTable& table, const std::string& key, double value) {
  return std::none_of(table.examples.begin(), table.examples.end(), [&](SchemaJson content) {
    content[key] = value;
    if (content[key] == static_cast<double>(static_cast<std::int64_t>(value)) &&
        !table.schema.at("properties").at(key).value("type", "").starts_with("n")) {
      content[key] = static_cast<std::int64_t>(value);
    }
    return table.complaint(content).empty();
  });
}

class SchemaAndReaders : public testing::Test {
 protected:
  /// Calls `check` with each key of each table, as both know it.
  template <typename Check>
  static void for_each_key(const Check& check) {
    for (const SchemaTable& table : schema_tables()) {
      for (const DescribedKey& key : table_of(table.file->name, table.name).keys) {
        SCOPED_TRACE(table.file->name + ": " + table.name + "." + key.rule.key);
        check(table, key.rule, table.schema.at("properties").at(key.rule.key));
      }
    }
  }
};

TEST_F(SchemaAndReaders, HaveTheSameTypes) {
  for_each_key([](const SchemaTable&, const TomlKey& rule, const SchemaJson& property) {
    EXPECT_THAT(rule.types, testing::UnorderedElementsAreArray(types_in(property)));
  });
}

TEST_F(SchemaAndReaders, HaveTheSameRanges) {
  for_each_key([](const SchemaTable& table, const TomlKey& rule, const SchemaJson& property) {
    if (!rule.minimum || property.contains("enum")) {
      return;
    }
    const SchemaJson& numbers = numbers_in(property);
    for (const auto& [end, value] :
         {std::pair{"minimum", *rule.minimum}, {"maximum", *rule.maximum}}) {
      if (numbers.contains(end)) {
        EXPECT_EQ(numbers.at(end).get<double>(), value) << end;
      } else {
        EXPECT_TRUE(is_refused(table, rule.key, value)) << "the schema has no " << end;
      }
    }
  });
}

TEST_F(SchemaAndReaders, HaveTheSameWords) {
  for_each_key([](const SchemaTable&, const TomlKey& rule, const SchemaJson& property) {
    std::vector<std::string> words;
    for (const SchemaJson& word : property.value("enum", SchemaJson::array())) {
      words.push_back(word.is_string() ? word.get<std::string>() : word.dump());
    }
    EXPECT_THAT(rule.words, ElementsAreArray(words));
  });
}

TEST_F(SchemaAndReaders, HaveTheSameDefaults) {
  for_each_key([](const SchemaTable&, const TomlKey& rule, const SchemaJson& property) {
    // Words that are empty are none.
    EXPECT_EQ(rule.default_text.has_value(), property.value("default", SchemaJson("")) != "");
    if (rule.default_text && property.contains("default")) {
      const SchemaJson& stated = property.at("default");
      EXPECT_EQ(stated.is_string() ? SchemaJson(*rule.default_text)
                                   : SchemaJson::parse(*rule.default_text),
                stated);
    }
  });
}

TEST_F(SchemaAndReaders, RequireTheSame) {
  for_each_key([](const SchemaTable& table, const TomlKey& rule, const SchemaJson&) {
    const SchemaJson required = table.schema.value("required", SchemaJson::array());
    EXPECT_EQ(rule.is_required,
              std::find(required.begin(), required.end(), rule.key) != required.end());
  });
}

}  // namespace
}  // namespace foveola::study
