// Which keys TOML files may have, learnt from the readers themselves while they read: what is
// written about the keys can then be made from this, or held against it.
#pragma once

#include <concepts>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace foveola {

/// A key as the code that reads it names it.
struct TomlKeyName {
  // Implicit, so that a key that may be absent is its name.
  template <std::convertible_to<std::string_view> Text>
  TomlKeyName(const Text& key, bool must_be_there = false)
      : name(key), is_required(must_be_there) {}
  operator std::string_view() const { return name; }

  std::string_view name;
  bool is_required;  ///< it is an error if the key is absent
};

/// The name of a key that must be there.
inline TomlKeyName required(std::string_view key) { return {key, true}; }

/// What a reader asks of a key's value.
struct TomlKeyRule {
  std::string type;               ///< in words: "whole number"
  std::optional<double> minimum;  ///< of each number of a list
  std::optional<double> maximum;
  std::vector<std::string> words;  ///< the only texts or numbers that it takes; empty: any
  std::optional<std::string>
      default_text;          ///< what counts if the key is absent; empty: nothing does
  std::string_view meaning;  ///< for people; empty: none stated
  std::string_view pattern;  ///< a regular expression of ECMA-262 that a text must match; or empty
};

/// A key that readers asked for.
struct TomlKey {
  std::string table;  ///< "tracker.validation", also of each of a list of tables; empty: the file
  std::string key;
  std::string meaning;
  std::string pattern;
  std::vector<std::string> types;  ///< in the order of asking; any of them will do
  std::optional<double> minimum;
  std::optional<double> maximum;
  std::vector<std::string> words;
  std::optional<std::string> default_text;  ///< as TomlKeyRule's; empty if it varies, too
  bool default_varies = false;              ///< with other keys, or with where the table stands
  bool is_required = false;                 ///< in every such table
  bool is_sometimes_required = false;       ///< in some, as other keys say
  std::string former;  ///< the name that it had in earlier versions; may be empty
};

/// What the readers of files of one kind asked for: each is given it, and tells it.
class TomlKeys {
 public:
  /// In the order in which they were first asked for.
  std::vector<TomlKey> keys() const;

  void asked(const std::string& table, std::string_view key, const TomlKeyRule& rule);
  /// All of a table was read, for which the reader asked for these keys.
  void finished(const std::string& table, const std::set<std::string, std::less<>>& asked);
  void required(const std::string& table, std::string_view key);
  void called_formerly(const std::string& table, std::string_view key, std::string_view former);

 private:
  struct Account {
    TomlKey key;
    std::set<std::optional<std::string>> defaults;
    bool is_awaited = false;  ///< it is required, and will be asked for: no default will do
    int asked = 0;
    int required = 0;
    int tables = 0;  ///< that were finished and asked for it
  };
  Account& account_of(const std::string& table, std::string_view key);

  std::vector<Account> accounts_;
  std::map<std::pair<std::string, std::string>, std::size_t> places_;  ///< by table and key
  std::map<std::string, int> finished_;                                ///< by table
};

}  // namespace foveola
