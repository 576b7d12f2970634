#include "renderer/base/toml/toml_keys.h"

#include <algorithm>

namespace foveola {

std::vector<TomlKey> TomlKeys::keys() const {
  std::vector<TomlKey> keys;
  for (const Account& account : accounts_) {
    // A key requested only by require() is read elsewhere, or not at all.
    if (account.asked == 0) {
      continue;
    }
    TomlKey key = account.key;
    const auto tables = finished_.find(key.table);
    key.is_required = account.required >= account.asked && tables != finished_.end() &&
                      account.tables == tables->second;
    key.is_sometimes_required = !key.is_required && account.required > 0;
    key.default_varies = !key.is_required && account.defaults.size() > 1;
    if (!key.is_required && account.defaults.size() == 1) {
      key.default_text = *account.defaults.begin();
    }
    keys.push_back(std::move(key));
  }
  return keys;
}

void TomlKeys::asked(const std::string& table, std::string_view key, const TomlKeyRule& rule) {
  Account& account = account_of(table, key);
  if (!rule.meaning.empty()) {
    account.key.meaning = rule.meaning;
    account.key.pattern = rule.pattern;
  }
  ++account.asked;
  if (!std::exchange(account.is_awaited, false)) {
    account.defaults.insert(rule.default_text);
  }
  std::vector<std::string>& types = account.key.types;
  if (std::ranges::find(types, rule.type) == types.end()) {
    types.push_back(rule.type);
  }
  if (!account.key.minimum) {
    account.key.minimum = rule.minimum;
    account.key.maximum = rule.maximum;
  }
  account.key.words = rule.words;
}

void TomlKeys::finished(const std::string& table, const std::set<std::string, std::less<>>& asked) {
  ++finished_[table];
  for (const std::string& key : asked) {
    ++account_of(table, key).tables;
  }
}

void TomlKeys::required(const std::string& table, std::string_view key) {
  Account& account = account_of(table, key);
  ++account.required;
  account.is_awaited = true;
}

void TomlKeys::called_formerly(const std::string& table, std::string_view key,
                               std::string_view former) {
  account_of(table, key).key.former = former;
}

TomlKeys::Account& TomlKeys::account_of(const std::string& table, std::string_view key) {
  const auto [place, is_new] = places_.try_emplace({table, std::string(key)}, accounts_.size());
  if (is_new) {
    accounts_.push_back({.key = {.table = table, .key = std::string(key)}});
  }
  return accounts_[place->second];
}

}  // namespace foveola
