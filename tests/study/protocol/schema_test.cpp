// Whether the schema for editors, protocols/foveola-protocol.schema.json, says what the readers
// do. The schema's own examples are read, and then spoilt one key at a time.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "study/protocol/schema_tables.h"
#include "study/protocol/texts.h"
#include "tests/matchers.h"

namespace foveola::study {
namespace {

using Json = SchemaJson;

/// The keys that the reader says it knows, from its own complaint; empty if it complained of
/// something else.
std::set<std::string> keys_in(const std::string& complaint) {
  const std::string start = "the keys here are ";
  const std::size_t begin = complaint.find(start);
  std::set<std::string> keys;
  std::istringstream list(begin == std::string::npos ? "" : complaint.substr(begin + start.size()));
  for (std::string key; std::getline(list >> std::ws, key, ',');) {
    keys.insert(key);
  }
  return keys;
}

/// Too much for a range that ends at `number`.
double slightly(double number) { return std::max(1e-7, 1e-9 * std::abs(number)); }

class ProtocolSchema : public testing::Test {
 protected:
  /// Calls `check` with each key of each table.
  void for_each_key(
      const std::function<void(const SchemaTable&, const std::string&, const Json&)>& check) const {
    for (const SchemaTable& table : tables_) {
      for (const auto& [key, property] : table.schema.at("properties").items()) {
        SCOPED_TRACE(table.file->name + ": " + table.name + "." + key);
        check(table, key, property);
      }
    }
  }

  /// Whether the reader takes `value` under `key` in none of the table's examples.
  static bool is_refused(const SchemaTable& table, const std::string& key, const Json& value) {
    for (Json content : table.examples) {
      content[key] = value;
      if (table.complaint(content).empty()) {
        return false;
      }
    }
    return true;
  }

  const std::vector<SchemaTable> tables_ = schema_tables();
};

TEST_F(ProtocolSchema, SpeaksOfEveryTableThatThereIs) {
  std::set<std::string> names;
  for (const SchemaTable& table : tables_) {
    names.insert(table.file->name + " " + table.name);
  }
  for (const char* name :
       {"", "display.lens", "tracker.validation", "tracker.filter.one_euro", "rating.options",
        "questionnaire.question.options", "override.film", "analysis.primary"}) {
    EXPECT_TRUE(names.contains(std::string("protocol ") + name)) << name;
  }
  for (const char* name : {"questionnaire file question.options", "display profile timing_patch",
                           "tracker profile open_gaze"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST_F(ProtocolSchema, ItsExamplesAreProtocols) {
  for (const SchemaTable& table : tables_) {
    for (const Json& example : table.examples) {
      EXPECT_EQ(table.complaint(example), "") << table.name << " " << example;
    }
  }
}

// The reader is asked which keys it knows by giving it one that nobody knows.
TEST_F(ProtocolSchema, KnowsTheKeysThatTheReaderKnows) {
  for (const SchemaTable& table : tables_) {
    std::set<std::string> known;
    for (Json content : table.examples) {
      content["nobody_knows_this"] = 1;
      known.merge(keys_in(table.complaint(content)));
    }
    std::set<std::string> listed;
    for (const auto& [key, property] : table.schema.at("properties").items()) {
      listed.insert(key);
    }
    EXPECT_EQ(known, listed) << table.name;
    EXPECT_EQ(table.schema.at("additionalProperties"), false) << table.name;
  }
}

TEST_F(ProtocolSchema, KnowsTheTypes) {
  const std::map<std::string, Json> wrong = {{"string", 3},  {"integer", 2.5}, {"number", "x"},
                                             {"boolean", 1}, {"array", 3},     {"object", 3}};
  for_each_key([&](const SchemaTable& table, const std::string& key, const Json& property) {
    if (property.contains("type")) {
      EXPECT_TRUE(is_refused(table, key, wrong.at(property.at("type").get<std::string>())));
    }
  });
}

bool is_of(const std::string& type, const Json& value) {
  return type == "string"    ? value.is_string()
         : type == "boolean" ? value.is_boolean()
         : type == "array"   ? value.is_array()
         : type == "integer" ? value.is_number_integer()
                             : value.is_number();
}

TEST_F(ProtocolSchema, ItsDefaultsAreOfTheirTypesAndRead) {
  for_each_key([&](const SchemaTable& table, const std::string& key, const Json& property) {
    if (property.contains("default")) {
      EXPECT_TRUE(is_of(property.at("type"), property.at("default")));
      EXPECT_FALSE(is_refused(table, key, property.at("default")));
    }
  });
}

TEST_F(ProtocolSchema, KnowsTheWords) {
  for_each_key([&](const SchemaTable& table, const std::string& key, const Json& property) {
    if (property.contains("enum")) {
      for (const Json& word : property.at("enum")) {
        EXPECT_FALSE(is_refused(table, key, word)) << word;
      }
      const Json other = property.at("enum").front().is_string() ? Json("another") : Json(7);
      EXPECT_TRUE(is_refused(table, key, other));
    }
  });
}

TEST_F(ProtocolSchema, KnowsTheRanges) {
  for_each_key([&](const SchemaTable& table, const std::string& key, const Json& property) {
    const bool is_whole = property.value("type", "") == "integer";
    for (const auto& [end, direction] : {std::pair{"minimum", -1}, std::pair{"maximum", 1}}) {
      if (property.contains(end)) {
        const Json last = property.at(end);
        const Json beyond = is_whole ? Json(last.get<std::int64_t>() + direction)
                                     : Json(last.get<double>() + direction * slightly(last));
        EXPECT_FALSE(is_refused(table, key, last)) << last;
        EXPECT_TRUE(is_refused(table, key, beyond)) << beyond;
      }
    }
  });
}

TEST_F(ProtocolSchema, KnowsTheBuiltInWords) {
  for (const auto& [id, property] :
       tables_.front().schema.at("properties").at("texts").at("properties").items()) {
    EXPECT_EQ(property.at("default"), text_of({}, id)) << id;
  }
}

}  // namespace
}  // namespace foveola::study
