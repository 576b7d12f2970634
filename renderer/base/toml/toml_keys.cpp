#include "renderer/base/toml/toml_keys.h"

#include <algorithm>

namespace foveola {

std::vector<TomlKey> TomlKeys::keys() const {
  std::vector<TomlKey> keys;
  for (const KeyRecord& record : records_) {
    // A key requested only by require() is read elsewhere, or not at all.
    if (record.requests == 0) {
      continue;
    }
    TomlKey key = record.key;
    const auto tables = finished_.find(key.table);
    key.is_required = record.required >= record.requests && tables != finished_.end() &&
                      record.tables == tables->second;
    key.is_sometimes_required = !key.is_required && record.required > 0;
    key.default_varies = !key.is_required && record.defaults.size() > 1;
    if (!key.is_required && record.defaults.size() == 1) {
      key.default_text = *record.defaults.begin();
    }
    keys.push_back(std::move(key));
  }
  return keys;
}

void TomlKeys::record_request(const std::string& table, std::string_view key,
                              const TomlKeyRule& rule) {
  KeyRecord& record = record_of(table, key);
  if (!rule.meaning.empty()) {
    record.key.meaning = rule.meaning;
    record.key.pattern = rule.pattern;
  }
  ++record.requests;
  if (!std::exchange(record.is_default_ignored, false)) {
    record.defaults.insert(rule.default_text);
  }
  std::vector<std::string>& types = record.key.types;
  if (std::ranges::find(types, rule.type) == types.end()) {
    types.push_back(rule.type);
  }
  if (!record.key.minimum) {
    record.key.minimum = rule.minimum;
    record.key.maximum = rule.maximum;
  }
  record.key.words = rule.words;
}

void TomlKeys::finished(const std::string& table, const std::set<std::string, std::less<>>& asked) {
  ++finished_[table];
  for (const std::string& key : asked) {
    ++record_of(table, key).tables;
  }
}

void TomlKeys::required(const std::string& table, std::string_view key) {
  KeyRecord& record = record_of(table, key);
  ++record.required;
  record.is_default_ignored = true;
}

void TomlKeys::called_formerly(const std::string& table, std::string_view key,
                               std::string_view former) {
  record_of(table, key).key.former = former;
}

TomlKeys::KeyRecord& TomlKeys::record_of(const std::string& table, std::string_view key) {
  const auto [place, is_new] = places_.try_emplace({table, std::string(key)}, records_.size());
  if (is_new) {
    records_.push_back({.key = {.table = table, .key = std::string(key)}});
  }
  return records_[place->second];
}

}  // namespace foveola
