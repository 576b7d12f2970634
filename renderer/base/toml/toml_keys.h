// The allowed keys of TOML files, recorded from the readers while they read. Documentation of the
// keys is made from this record or checked against it.
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
  // Implicit, so that a text alone names an optional key.
  template <std::convertible_to<std::string_view> Text>
  TomlKeyName(const Text& key, bool must_be_there = false)
      : name(key), is_required(must_be_there) {}
  operator std::string_view() const { return name; }

  std::string_view name;
  bool is_required;  ///< it is an error if the key is absent
};

/// The name of a required key.
inline TomlKeyName required(std::string_view key) { return {key, true}; }

/// A reader's constraints on a key's value.
struct TomlKeyRule {
  std::string type;               ///< in words: "whole number"
  std::optional<double> minimum;  ///< of each number of a list
  std::optional<double> maximum;
  std::vector<std::string> words;           ///< the only texts or numbers allowed; empty: any
  std::optional<std::string> default_text;  ///< the value if the key is absent; empty: none
  std::string_view meaning;                 ///< for people; empty: none stated
  std::string_view pattern;  ///< a regular expression of ECMA-262 that a text must match; or empty
};

/// A key that readers requested.
struct TomlKey {
  std::string table;  ///< "tracker.validation", also of each of a list of tables; empty: the file
  std::string key;
  std::string meaning;
  std::string pattern;
  std::vector<std::string> types;  ///< in the order of requests; any of them is allowed
  std::optional<double> minimum;
  std::optional<double> maximum;
  std::vector<std::string> words;
  std::optional<std::string> default_text;  ///< as TomlKeyRule's; empty if it varies, too
  bool default_varies = false;              ///< depends on other keys, or on the table's place
  bool is_required = false;                 ///< in every such table
  bool is_sometimes_required = false;       ///< in some tables, as other keys say
  std::string former;                       ///< the key's name in earlier versions; may be empty
};

/// Collects the keys that the readers of one kind of file request.
class TomlKeys {
 public:
  /// In the order of their first request.
  std::vector<TomlKey> keys() const;

  /// Records one request of a key. Types and defaults accumulate; the first stated range is kept,
  /// and the last list of allowed values.
  void record_request(const std::string& table, std::string_view key, const TomlKeyRule& rule);
  /// Records that a table was read completely, with these requested keys.
  void finished(const std::string& table, const std::set<std::string, std::less<>>& asked);
  void required(const std::string& table, std::string_view key);
  void called_formerly(const std::string& table, std::string_view key, std::string_view former);

 private:
  struct KeyRecord {
    TomlKey key;
    std::set<std::optional<std::string>> defaults;
    bool is_default_ignored = false;  ///< at the next request, since that key is required
    int requests = 0;
    int required = 0;
    int tables = 0;  ///< finished tables in which it was requested
  };
  KeyRecord& record_of(const std::string& table, std::string_view key);

  std::vector<KeyRecord> records_;
  std::map<std::pair<std::string, std::string>, std::size_t> places_;  ///< by table and key
  std::map<std::string, int> finished_;                                ///< by table
};

}  // namespace foveola
