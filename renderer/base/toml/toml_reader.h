// Reads a TOML table key by key, reporting the place of every error.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "renderer/base/text/words.h"
#include "renderer/base/toml/toml_keys.h"
#include "renderer/base/vec.h"

namespace foveola {

/// One table of a file. Each read_ function leaves `value` unchanged where the key is absent and
/// throws Error where it has another type or lies out of range.
class TomlReader {
 public:
  /// name: the table's, for messages; empty for the file itself. keys: records the requested keys
  /// of this table and its subtables, and must outlive them; may be null.
  TomlReader(std::string file, const toml::table& table, std::string name,
             TomlKeys* keys = nullptr);

  /// pattern: a regular expression of ECMA-262 for editors; the caller checks the text.
  void read(const TomlKeyName& key, std::string& value, std::string_view meaning = {},
            std::string_view pattern = {});
  void read(const TomlKeyName& key, bool& value, std::string_view meaning = {});
  /// Within [minimum, maximum].
  void read(const TomlKeyName& key, int& value, int minimum, int maximum,
            std::string_view meaning = {});
  void read(const TomlKeyName& key, std::optional<int>& value, int minimum, int maximum,
            std::string_view meaning = {});
  void read(const TomlKeyName& key, std::int64_t& value, std::int64_t minimum, std::int64_t maximum,
            std::string_view meaning = {});
  /// Finite and within [minimum, maximum]; whole numbers are accepted.
  void read(const TomlKeyName& key, double& value, double minimum, double maximum,
            std::string_view meaning = {});
  void read(const TomlKeyName& key, std::optional<double>& value, double minimum, double maximum,
            std::string_view meaning = {});
  /// Arrays with as many numbers as the vector has components, each as above.
  void read(const TomlKeyName& key, Vec2& value, double minimum, double maximum,
            std::string_view meaning = {});
  void read(const TomlKeyName& key, std::optional<Vec2>& value, double minimum, double maximum,
            std::string_view meaning = {});
  void read(const TomlKeyName& key, Vec3& value, double minimum, double maximum,
            std::string_view meaning = {});
  /// One of `choices`, which are in ascending order.
  void read(const TomlKeyName& key, int& value, const std::vector<int>& choices,
            std::string_view meaning = {});
  /// One of `words`.
  template <typename Value, std::size_t count>
  void read(const TomlKeyName& key, Value& value, const std::array<Word<Value>, count>& words,
            std::string_view meaning = {}) {
    std::vector<std::string_view> known;
    std::optional<std::string> default_text;
    known.reserve(count);
    for (const Word<Value>& word : words) {
      known.push_back(word.text);
      if (word.value == value) {
        default_text = word.text;
      }
    }
    if (const std::size_t found = find_word(key, known, default_text, meaning); found < count) {
      value = words[found].value;
    }
  }

  /// `key`, or its former name if the table has only that, which adds a note.
  TomlKeyName present_name(const TomlKeyName& key, std::string_view former);

  /// One line per key that stands under its former name, in all tables of the file read so far.
  const std::vector<std::string>& notes() const { return *notes_; }

  bool has(std::string_view key) const { return table_->contains(key); }
  bool is_array(std::string_view key) const { return has(key) && table_->get(key)->is_array(); }
  /// Throws Error if the key is absent.
  void require(std::string_view key) const;

  /// A string and its place in the file.
  struct Text {
    std::string value;
    toml::source_region source;
  };
  /// A non-empty array of at most 1000 different strings; empty if the key is absent.
  std::vector<Text> texts(const TomlKeyName& key, std::string_view meaning = {});
  /// The same strings of a required key: throws Error if it is absent.
  std::vector<Text> require_texts(const TomlKeyName& key, std::string_view meaning = {});
  /// Throws Error if the key is absent or empty.
  std::string require_text(const TomlKeyName& key, std::string_view meaning = {},
                           std::string_view pattern = {});

  /// The table `key`, or an empty one.
  TomlReader table(const TomlKeyName& key, std::string_view meaning = {});
  /// The same, for a table whose keys are ids that the file chooses.
  TomlReader table_by_ids(const TomlKeyName& key, std::string_view meaning = {});
  /// Reads the table `key` by `read`; leaves `value` unchanged if it is absent.
  template <typename Value, typename Read>
  void read_table(const TomlKeyName& key, Value& value, const Read& read,
                  std::string_view meaning = {}) {
    TomlReader inner = table(key, meaning);
    if (has(key)) {
      value = read(std::move(inner));
    }
  }
  /// The array of at most 1000 tables `key`, or none.
  std::vector<TomlReader> tables(const TomlKeyName& key, std::string_view meaning = {});

  /// Throws Error for the first key that nothing asked for. To be called after all reading.
  void reject_unknown_keys() const;

  [[noreturn]] void fail(const toml::source_region& source, const std::string& what,
                         const std::string& remedy) const;
  /// The place of the key's value, or of the table itself. The key must be present.
  const toml::source_region& source(std::string_view key) const {
    return table_->get(key)->source();
  }
  const toml::source_region& source() const { return table_->source(); }

 private:
  TomlReader table_of(const char* type, const TomlKeyName& key, std::string_view meaning);
  TomlReader inner(const toml::table& table, std::string_view key) const;
  /// Null if the key is absent.
  const toml::node* find(const TomlKeyName& key, const TomlKeyRule& rule);
  void read_whole(const TomlKeyName& key, std::int64_t& value, const TomlKeyRule& rule,
                  std::int64_t minimum, std::int64_t maximum);
  void read_number(const TomlKeyName& key, double& value, const TomlKeyRule& rule);
  std::string text_in(const toml::node& node, std::string_view key) const;
  void note_required(std::string_view key) const;
  void require_moderate_length(std::string_view key, const toml::array& array) const;
  std::string full_name(std::string_view key) const;
  /// The index in `known` of the text under `key`; known.size() if the key is absent.
  std::size_t find_word(const TomlKeyName& key, const std::vector<std::string_view>& known,
                        const std::optional<std::string>& default_text, std::string_view meaning);
  template <typename Vector>
  void read_vector(const TomlKeyName& key, Vector& value, double minimum, double maximum,
                   const std::optional<std::string>& default_text, std::string_view meaning);

  std::string file_;
  const toml::table* table_;
  std::string name_;
  TomlKeys* keys_;
  std::set<std::string, std::less<>> asked_;
  std::shared_ptr<std::vector<std::string>> notes_;  ///< shared by all tables of the file
};

}  // namespace foveola
