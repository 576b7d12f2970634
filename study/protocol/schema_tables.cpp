#include "study/protocol/schema_tables.h"

#include <stdexcept>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"
#include "renderer/gaze/profiles.h"
#include "study/protocol/protocol.h"
#include "study/protocol/read_questions.h"

namespace foveola::study {
namespace {

constexpr const char* example_name = "example.toml";

void read_example_protocol(const std::string& toml, TomlKeys* keys) {
  read_protocol(toml, example_name, keys);
}

void read_example_questionnaire(const std::string& toml, TomlKeys* keys) {
  read_questionnaire_file(example_name, toml, keys);
}

void read_example_display(const std::string& toml, TomlKeys* keys) {
  display_profile_in(toml, example_name, keys);
}

void read_example_tracker(const std::string& toml, TomlKeys* keys) {
  tracker_profile_in(toml, example_name, keys);
}

/// TOML that fits on one line.
std::string toml_of(const SchemaJson& value) {
  std::string text;
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items()) {
      text += (text.empty() ? "" : ", ") + key + " = " + toml_of(inner);
    }
    return "{ " + text + " }";
  }
  if (value.is_array()) {
    for (const SchemaJson& inner : value) {
      text += (text.empty() ? "" : ", ") + toml_of(inner);
    }
    return "[" + text + "]";
  }
  return value.dump();
}

/// Goes through the schema of one kind of file.
class SchemaWalk {
 public:
  SchemaWalk(const SchemaJson& root, SchemaFile file)
      : root_(root), file_(std::make_shared<const SchemaFile>(std::move(file))) {
    SchemaTable whole = table_of("", false, file_->schema.value("description", ""), file_->schema,
                                 SchemaJson::json_pointer());
    whole.document = whole.examples.front();
    add(whole);
  }

  std::vector<SchemaTable> tables() && { return std::move(tables_); }

 private:
  /// The schema that a $ref refers to.
  SchemaJson resolved(const SchemaJson& schema) const {
    if (!schema.contains("$ref")) {
      return schema;
    }
    const auto reference = schema.at("$ref").get<std::string>();
    SchemaJson referred = root_.at(SchemaJson::json_pointer(reference.substr(1)));
    if (schema.contains("description")) {
      referred["description"] = schema.at("description");
    }
    return referred;
  }

  SchemaTable table_of(std::string name, bool is_list, std::string meaning, SchemaJson schema,
                       SchemaJson::json_pointer place) const {
    for (const auto& item : schema.at("properties").items()) {
      schema["properties"][item.key()] = resolved(item.value());
    }
    std::vector<SchemaJson> examples{SchemaJson::object()};
    if (schema.contains("examples")) {
      examples = schema.at("examples").get<std::vector<SchemaJson>>();
    }
    return {.file = file_,
            .name = std::move(name),
            .is_list = is_list,
            .meaning = std::move(meaning),
            .schema = std::move(schema),
            .document = {},
            .place = std::move(place),
            .examples = std::move(examples)};
  }

  void add(const SchemaTable& table) {
    tables_.push_back(table);
    for (const auto& [key, property] : table.schema.at("properties").items()) {
      const std::string name = table.name.empty() ? key : table.name + "." + key;
      const std::string meaning = property.value("description", "");
      if (property.contains("properties")) {
        add_inner(table, key, table_of(name, false, meaning, property, table.place / key));
      } else if (property.contains("items")) {
        const SchemaJson item = resolved(property.at("items"));
        if (item.contains("properties")) {
          add_inner(table, key, table_of(name, true, meaning, item, table.place / key / 0));
        }
      }
    }
  }

  /// In the first of the outer table's examples that may have such a table in it.
  void add_inner(const SchemaTable& outer, const std::string& key, SchemaTable table) {
    for (SchemaJson content : outer.examples) {
      if (!table.is_list) {
        content[key] = table.examples.front();
      } else if (!content.contains(key)) {
        content[key] = SchemaJson::array({table.examples.front()});
      }
      if (outer.complaint(content).empty()) {
        table.document = outer.document;
        table.document[outer.place] = content;
        add(table);
        return;
      }
    }
    throw std::logic_error("no example in the schema can have the table " + table.name);
  }

  const SchemaJson& root_;
  std::shared_ptr<const SchemaFile> file_;
  std::vector<SchemaTable> tables_;
};

}  // namespace

std::string SchemaTable::toml_with(const SchemaJson& content) const {
  SchemaJson changed = document;
  changed[place] = content;
  std::string text;
  for (const auto& [key, value] : changed.items()) {
    text += key + " = " + toml_of(value) + "\n";
  }
  return text;
}

std::string SchemaTable::complaint(const SchemaJson& content, TomlKeys* keys) const {
  try {
    file->read(toml_with(content), keys);
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

std::vector<SchemaTable> schema_tables() {
  const SchemaJson root = SchemaJson::parse(
      read_file(resource_folder() / "protocols" / "foveola-protocol.schema.json"));
  const SchemaJson& definitions = root.at("definitions");
  std::vector<SchemaTable> tables;
  for (SchemaFile file :
       {SchemaFile{"protocol", root, read_example_protocol},
        SchemaFile{"questionnaire file", definitions.at("questionnaire_file"),
                   read_example_questionnaire},
        SchemaFile{"display profile", definitions.at("display_profile"), read_example_display},
        SchemaFile{"tracker profile", definitions.at("tracker_profile"), read_example_tracker}}) {
    for (SchemaTable& table : SchemaWalk(root, std::move(file)).tables()) {
      tables.push_back(std::move(table));
    }
  }
  return tables;
}

}  // namespace foveola::study
