// Whether the schema for editors, protocols/foveola-protocol.schema.json, says what the reader
// does. The schema's own examples are read, and then spoilt one key at a time.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "study/protocol/protocol.h"
#include "study/protocol/texts.h"

namespace foveola::study {
namespace {

using Json = nlohmann::json;

/// TOML that fits on one line.
std::string toml_of(const Json& value) {
  std::string text;
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items()) {
      text += (text.empty() ? "" : ", ") + key + " = " + toml_of(inner);
    }
    return "{ " + text + " }";
  }
  if (value.is_array()) {
    for (const Json& inner : value) {
      text += (text.empty() ? "" : ", ") + toml_of(inner);
    }
    return "[" + text + "]";
  }
  return value.dump();
}

std::string toml_file_of(const Json& document) {
  std::string text;
  for (const auto& [key, value] : document.items()) {
    text += key + " = " + toml_of(value) + "\n";
  }
  return text;
}

/// The reader's error for a protocol; empty if it accepts it.
std::string complaint(const Json& document) {
  try {
    read_protocol(toml_file_of(document), "p.toml");
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

/// A table of the schema, and a document in which it stands.
struct Table {
  std::string name;          ///< As "tracker.validation".
  Json schema;               ///< The table's schema, with properties.
  Json document;             ///< A valid document with the table in it.
  Json::json_pointer place;  ///< The place of the table in the document.

  /// The document with the table replaced.
  Json with(const Json& content) const {
    Json changed = document;
    changed[place] = content;
    return changed;
  }
};

/// Everything of the schema that a table of a protocol can be.
class Schema {
 public:
  Schema()
      : root_(
            Json::parse(read_file(resource_folder() / "protocols/foveola-protocol.schema.json"))) {
    add("", root_, root_.at("examples").at(0), Json::json_pointer());
  }

  const std::vector<Table>& tables() const { return tables_; }
  const Json& root() const { return root_; }

  /// The schema that a $ref refers to.
  Json resolved(const Json& schema) const {
    if (!schema.contains("$ref")) {
      return schema;
    }
    const auto reference = schema.at("$ref").get<std::string>();
    return root_.at(Json::json_pointer(reference.substr(1)));
  }

  static std::vector<Json> examples_of(const Json& schema) {
    return schema.contains("examples") ? schema.at("examples").get<std::vector<Json>>()
                                       : std::vector<Json>{Json::object()};
  }

 private:
  void add(const std::string& name, const Json& schema, const Json& document,
           const Json::json_pointer& place) {
    tables_.push_back({name, schema, document, place});
    const Table table = tables_.back();
    for (const auto& [key, property] : schema.at("properties").items()) {
      const std::string inner_name = name.empty() ? key : name + "." + key;
      const Json inner = resolved(property);
      if (inner.contains("properties")) {
        add_inner(table, inner_name, inner, key, place / key);
      } else if (inner.contains("items") && resolved(inner.at("items")).contains("properties")) {
        add_inner(table, inner_name, resolved(inner.at("items")), key, place / key / 0);
      }
    }
  }

  /// In the first of the table's examples that may have such a table in it.
  void add_inner(const Table& table, const std::string& name, const Json& schema,
                 const std::string& key, const Json::json_pointer& place) {
    const bool is_list = place.back() == "0";
    for (Json content : examples_of(table.schema)) {
      const Json example = examples_of(schema).front();
      content[key] = !is_list                ? example
                     : content.contains(key) ? content[key]
                                             : Json::array({example});
      if (const Json document = table.with(content); complaint(document).empty()) {
        add(name, schema, document, place);
        return;
      }
    }
    ADD_FAILURE() << "no example can have a " << name;
  }

  Json root_;
  std::vector<Table> tables_;
};

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
      const std::function<void(const Table&, const std::string&, const Json&)>& check) const {
    for (const Table& table : schema_.tables()) {
      for (const auto& [key, property] : table.schema.at("properties").items()) {
        SCOPED_TRACE(table.name + "." + key);
        check(table, key, schema_.resolved(property));
      }
    }
  }

  /// Whether the reader takes `value` under `key` in none of the table's examples.
  static bool is_refused(const Table& table, const std::string& key, const Json& value) {
    for (Json content : Schema::examples_of(table.schema)) {
      content[key] = value;
      if (complaint(table.with(content)).empty()) {
        return false;
      }
    }
    return true;
  }

  const Schema schema_;
};

TEST_F(ProtocolSchema, SpeaksOfEveryTableThatThereIs) {
  std::set<std::string> names;
  for (const Table& table : schema_.tables()) {
    names.insert(table.name);
  }
  for (const char* name :
       {"", "display.lens", "tracker.validation", "tracker.filter.one_euro", "rating.options",
        "questionnaire.question.options", "override.film", "analysis.primary"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
}

TEST_F(ProtocolSchema, ItsExamplesAreProtocols) {
  for (const Table& table : schema_.tables()) {
    for (const Json& example : Schema::examples_of(table.schema)) {
      EXPECT_EQ(complaint(table.with(example)), "") << table.name << " " << example;
    }
  }
}

// The reader is asked which keys it knows by giving it one that nobody knows.
TEST_F(ProtocolSchema, KnowsTheKeysThatTheReaderKnows) {
  for (const Table& table : schema_.tables()) {
    std::set<std::string> known;
    for (Json content : Schema::examples_of(table.schema)) {
      content["nobody_knows_this"] = 1;
      known.merge(keys_in(complaint(table.with(content))));
    }
    std::set<std::string> listed;
    for (const auto& [key, property] : table.schema.at("properties").items()) {
      listed.insert(key);
    }
    EXPECT_EQ(known, listed) << table.name;
    EXPECT_EQ(table.schema.at("additionalProperties"), false) << table.name;
  }
}

TEST_F(ProtocolSchema, KnowsWhatMustBeThere) {
  for (const Table& table : schema_.tables()) {
    const Json required = table.schema.value("required", Json::array());
    for (const Json& key : required) {
      Json content = Schema::examples_of(table.schema).front();
      content.erase(key.get<std::string>());
      EXPECT_NE(complaint(table.with(content)), "") << table.name << "." << key;
    }
  }
}

TEST_F(ProtocolSchema, KnowsTheTypes) {
  const std::map<std::string, Json> wrong = {{"string", 3},  {"integer", 2.5}, {"number", "x"},
                                             {"boolean", 1}, {"array", 3},     {"object", 3}};
  for_each_key([&](const Table& table, const std::string& key, const Json& property) {
    if (property.contains("type")) {
      EXPECT_TRUE(is_refused(table, key, wrong.at(property.at("type").get<std::string>())));
    }
  });
}

bool is_of(const std::string& type, const Json& value) {
  return type == "string"    ? value.is_string()
         : type == "boolean" ? value.is_boolean()
         : type == "integer" ? value.is_number_integer()
                             : value.is_number();
}

TEST_F(ProtocolSchema, ItsDefaultsAreOfTheirTypesAndRead) {
  for_each_key([&](const Table& table, const std::string& key, const Json& property) {
    if (property.contains("default")) {
      EXPECT_TRUE(is_of(property.at("type"), property.at("default")));
      EXPECT_FALSE(is_refused(table, key, property.at("default")));
    }
  });
}

TEST_F(ProtocolSchema, KnowsTheWords) {
  for_each_key([&](const Table& table, const std::string& key, const Json& property) {
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
  for_each_key([&](const Table& table, const std::string& key, const Json& property) {
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
       schema_.root().at("/properties/texts/properties"_json_pointer).items()) {
    EXPECT_EQ(property.at("default"), text_of({}, id)) << id;
  }
}

}  // namespace
}  // namespace foveola::study
