#include "renderer/base/toml/toml_reader.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/base/text/similar_word.h"
#include "renderer/base/toml/toml_file.h"
#include "renderer/base/transformed.h"

namespace foveola {
namespace {

/// Above any study's: entries may be processed pairwise.
constexpr std::size_t longest_list = 1000;

constexpr const char* whole_number = "whole number";

/// A value as TOML writes it.
template <typename Value>
std::optional<std::string> text_of(const std::optional<Value>& value) {
  return value ? std::optional(fmt::format("{}", *value)) : std::nullopt;
}

template <typename Value>
TomlKeyRule rule_of(const char* type, const std::optional<Value>& value, Value minimum,
                    Value maximum, std::string_view meaning) {
  return {.type = type,
          .minimum = static_cast<double>(minimum),
          .maximum = static_cast<double>(maximum),
          .words = {},
          .default_text = text_of(value),
          .meaning = meaning};
}

TomlKeyRule rule_of(std::string type, std::string_view meaning, std::string_view pattern = {}) {
  return {.type = std::move(type), .meaning = meaning, .pattern = pattern};
}

}  // namespace

TomlReader::TomlReader(std::string file, const toml::table& table, std::string name, TomlKeys* keys)
    : file_(std::move(file)),
      table_(&table),
      name_(std::move(name)),
      keys_(keys),
      notes_(std::make_shared<std::vector<std::string>>()) {}

TomlKeyName TomlReader::present_name(const TomlKeyName& key, std::string_view former) {
  if (keys_ != nullptr) {
    keys_->called_formerly(name_, key, former);
  }
  if (has(key) || !has(former)) {
    return key;
  }
  notes_->push_back(fmt::format("{}: '{}' is now called '{}'", place_of(file_, source(former)),
                                full_name(former), full_name(key)));
  return former;
}

void TomlReader::read(const TomlKeyName& key, std::string& value, std::string_view meaning,
                      std::string_view pattern) {
  TomlKeyRule rule = rule_of("text", meaning, pattern);
  if (!value.empty()) {
    rule.default_text = value;
  }
  if (const toml::node* node = find(key, rule)) {
    value = text_in(*node, key);
  }
}

std::string TomlReader::text_in(const toml::node& node, std::string_view key) const {
  const auto text = node.value_exact<std::string>();
  if (!text) {
    fail(node.source(), full_name(key) + " must be a text", "put it in double quotes");
  }
  return *text;
}

void TomlReader::read(const TomlKeyName& key, bool& value, std::string_view meaning) {
  TomlKeyRule rule = rule_of("true or false", meaning);
  rule.default_text = fmt::format("{}", value);
  if (const toml::node* node = find(key, rule)) {
    const auto flag = node->value_exact<bool>();
    if (!flag) {
      fail(node->source(), full_name(key) + " must be true or false", {});
    }
    value = *flag;
  }
}

void TomlReader::read(const TomlKeyName& key, int& value, int minimum, int maximum,
                      std::string_view meaning) {
  std::int64_t number = value;
  read(key, number, minimum, maximum, meaning);
  value = static_cast<int>(number);
}

void TomlReader::read(const TomlKeyName& key, std::optional<int>& value, int minimum, int maximum,
                      std::string_view meaning) {
  std::int64_t number = value.value_or(0);
  read_whole(key, number, rule_of(whole_number, value, minimum, maximum, meaning), minimum,
             maximum);
  if (has(key)) {
    value = static_cast<int>(number);
  }
}

void TomlReader::read(const TomlKeyName& key, std::int64_t& value, std::int64_t minimum,
                      std::int64_t maximum, std::string_view meaning) {
  read_whole(key, value, rule_of(whole_number, std::optional(value), minimum, maximum, meaning),
             minimum, maximum);
}

void TomlReader::read(const TomlKeyName& key, int& value, const std::vector<int>& choices,
                      std::string_view meaning) {
  TomlKeyRule rule =
      rule_of(whole_number, std::optional(value), choices.front(), choices.back(), meaning);
  for (const int choice : choices) {
    rule.words.push_back(fmt::format("{}", choice));
  }
  std::int64_t number = value;
  read_whole(key, number, rule, choices.front(), choices.back());
  value = static_cast<int>(number);
  if (has(key) && std::ranges::find(choices, value) == choices.end()) {
    fail(source(key), fmt::format("{} cannot be {}", full_name(key), value),
         fmt::format("choose {}", fmt::join(choices, " or ")));
  }
}

void TomlReader::read_whole(const TomlKeyName& key, std::int64_t& value, const TomlKeyRule& rule,
                            std::int64_t minimum, std::int64_t maximum) {
  if (const toml::node* node = find(key, rule)) {
    const auto number = node->value_exact<std::int64_t>();
    if (!number || *number < minimum || *number > maximum) {
      fail(node->source(), full_name(key) + " is out of range",
           fmt::format("give a whole number from {} to {}", minimum, maximum));
    }
    value = *number;
  }
}

void TomlReader::read(const TomlKeyName& key, double& value, double minimum, double maximum,
                      std::string_view meaning) {
  read_number(key, value, rule_of("number", std::optional(value), minimum, maximum, meaning));
}

void TomlReader::read(const TomlKeyName& key, std::optional<double>& value, double minimum,
                      double maximum, std::string_view meaning) {
  double number = 0.0;
  read_number(key, number, rule_of("number", value, minimum, maximum, meaning));
  if (has(key)) {
    value = number;
  }
}

void TomlReader::read_number(const TomlKeyName& key, double& value, const TomlKeyRule& rule) {
  if (const toml::node* node = find(key, rule)) {
    const auto number = node->is_number() ? node->value<double>() : std::nullopt;
    if (!number || !(*number >= *rule.minimum && *number <= *rule.maximum)) {
      fail(node->source(), full_name(key) + " is out of range",
           fmt::format("give a number from {} to {}", *rule.minimum, *rule.maximum));
    }
    value = *number;
  }
}

template <typename Vector>
void TomlReader::read_vector(const TomlKeyName& key, Vector& value, double minimum, double maximum,
                             const std::optional<std::string>& default_text,
                             std::string_view meaning) {
  TomlKeyRule rule = rule_of(fmt::format("list of {} numbers", Vector::length()), meaning);
  rule.minimum = minimum;
  rule.maximum = maximum;
  rule.default_text = default_text;
  const toml::node* node = find(key, rule);
  if (node == nullptr) {
    return;
  }
  const toml::array* array = node->as_array();
  if (array == nullptr || array->size() != static_cast<std::size_t>(Vector::length())) {
    fail(node->source(),
         fmt::format("{} must be a list of {} numbers", full_name(key), Vector::length()), {});
  }
  for (int i = 0; i < Vector::length(); ++i) {
    const toml::node& element = *array->get(static_cast<std::size_t>(i));
    const auto number = element.is_number() ? element.value<double>() : std::nullopt;
    if (!number || !(*number >= minimum && *number <= maximum)) {
      fail(element.source(), full_name(key) + " is out of range",
           fmt::format("give numbers from {} to {}", minimum, maximum));
    }
    value[i] = static_cast<float>(*number);
  }
}

void TomlReader::read(const TomlKeyName& key, Vec2& value, double minimum, double maximum,
                      std::string_view meaning) {
  read_vector(key, value, minimum, maximum, fmt::format("[{}, {}]", value.x, value.y), meaning);
}

void TomlReader::read(const TomlKeyName& key, std::optional<Vec2>& value, double minimum,
                      double maximum, std::string_view meaning) {
  Vec2 both(0.0F);
  read_vector(key, both, minimum, maximum, std::nullopt, meaning);
  if (has(key)) {
    value = both;
  }
}

void TomlReader::read(const TomlKeyName& key, Vec3& value, double minimum, double maximum,
                      std::string_view meaning) {
  read_vector(key, value, minimum, maximum, fmt::format("[{}, {}, {}]", value.x, value.y, value.z),
              meaning);
}

std::size_t TomlReader::find_word(const TomlKeyName& key,
                                  const std::vector<std::string_view>& known,
                                  const std::optional<std::string>& default_text,
                                  std::string_view meaning) {
  TomlKeyRule rule = rule_of("text", meaning);
  rule.words.assign(known.begin(), known.end());
  rule.default_text = default_text;
  const toml::node* node = find(key, rule);
  if (node == nullptr) {
    return known.size();
  }
  const std::string text = text_in(*node, key);
  const auto found = std::ranges::find(known, text);
  if (found == known.end()) {
    fail(source(key), fmt::format("there is no {} '{}'", key.name, text),
         did_you_mean(text, {known.begin(), known.end()},
                      fmt::format("choose one of {}", fmt::join(known, ", "))));
  }
  return static_cast<std::size_t>(found - known.begin());
}

void TomlReader::require(std::string_view key) const {
  note_required(key);
  if (!has(key)) {
    fail(source(), full_name(key) + " is missing", {});
  }
}

std::vector<TomlReader::Text> TomlReader::texts(const TomlKeyName& key, std::string_view meaning) {
  const toml::node* node = find(key, rule_of("list of texts", meaning));
  if (node == nullptr) {
    return {};
  }
  const toml::array* array = node->as_array();
  if (array == nullptr || array->empty() || !array->is_homogeneous<std::string>()) {
    fail(node->source(), full_name(key) + " must be a list of texts", R"(write ["a", "b"])");
  }
  require_moderate_length(key, *array);
  std::vector<Text> texts;
  std::set<std::string_view> known;
  for (const toml::node& element : *array) {
    const std::string& value = **element.as_string();
    if (!known.insert(value).second) {
      fail(element.source(), fmt::format("{} names '{}' twice", full_name(key), value),
           "name each once");
    }
    texts.push_back({value, element.source()});
  }
  return texts;
}

std::vector<TomlReader::Text> TomlReader::require_texts(const TomlKeyName& key,
                                                        std::string_view meaning) {
  note_required(key);
  if (!has(key)) {
    fail(source(), full_name(key) + " is missing", "give a list of names");
  }
  return texts(key, meaning);
}

std::string TomlReader::require_text(const TomlKeyName& key, std::string_view meaning,
                                     std::string_view pattern) {
  note_required(key);
  std::string value;
  read(key, value, meaning, pattern);
  if (value.empty()) {
    fail(source(), full_name(key) + " is missing or empty", "give a text");
  }
  return value;
}

TomlReader TomlReader::table(const TomlKeyName& key, std::string_view meaning) {
  return table_of("table", key, meaning);
}

TomlReader TomlReader::table_by_ids(const TomlKeyName& key, std::string_view meaning) {
  return table_of("table by ids", key, meaning);
}

TomlReader TomlReader::table_of(const char* type, const TomlKeyName& key,
                                std::string_view meaning) {
  static const toml::table absent;
  const toml::node* node = find(key, rule_of(type, meaning));
  if (node != nullptr && !node->is_table()) {
    fail(node->source(), full_name(key) + " must be a table",
         fmt::format("write [{}] on a line of its own", full_name(key)));
  }
  return inner(node != nullptr ? *node->as_table() : absent, key);
}

std::vector<TomlReader> TomlReader::tables(const TomlKeyName& key, std::string_view meaning) {
  const toml::node* node = find(key, rule_of("list of tables", meaning));
  if (node == nullptr) {
    return {};
  }
  if (!node->is_array_of_tables()) {
    fail(node->source(), full_name(key) + " must be a list of tables",
         fmt::format("begin each with [[{}]]", full_name(key)));
  }
  require_moderate_length(key, *node->as_array());
  return transformed(*node->as_array(),
                     [&](const toml::node& element) { return inner(*element.as_table(), key); });
}

void TomlReader::reject_unknown_keys() const {
  if (keys_ != nullptr) {
    keys_->finished(name_, asked_);
  }
  for (auto&& [key, node] : *table_) {
    if (!asked_.contains(key.str())) {
      fail(key.source(), fmt::format("unknown key '{}'", full_name(key.str())),
           did_you_mean(key.str(), {asked_.begin(), asked_.end()},
                        fmt::format("the keys here are {}", fmt::join(asked_, ", "))));
    }
  }
}

void TomlReader::fail(const toml::source_region& source, const std::string& what,
                      const std::string& remedy) const {
  throw Error(place_of(file_, source), what, remedy);
}

TomlReader TomlReader::inner(const toml::table& table, std::string_view key) const {
  TomlReader reader(file_, table, full_name(key), keys_);
  reader.notes_ = notes_;
  return reader;
}

const toml::node* TomlReader::find(const TomlKeyName& key, const TomlKeyRule& rule) {
  if (key.is_required) {
    require(key);
  }
  asked_.emplace(key.name);
  if (keys_ != nullptr) {
    keys_->record_request(name_, key, rule);
  }
  return table_->get(key);
}

void TomlReader::note_required(std::string_view key) const {
  if (keys_ != nullptr) {
    keys_->required(name_, key);
  }
}

void TomlReader::require_moderate_length(std::string_view key, const toml::array& array) const {
  if (array.size() > longest_list) {
    fail(array.source(),
         fmt::format("{} has {} entries, and at most {} are read", full_name(key), array.size(),
                     longest_list),
         "name fewer");
  }
}

std::string TomlReader::full_name(std::string_view key) const {
  return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

}  // namespace foveola
