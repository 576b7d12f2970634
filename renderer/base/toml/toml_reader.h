// Reading a TOML table key by key, with the place of whatever is wrong in it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "renderer/base/toml/toml_keys.h"
#include "renderer/base/vec.h"

namespace foveola {

/// A text that may stand in a file, and what it stands for.
template <typename Value>
struct Word {
  std::string_view text;
  Value value;
};

/// One table of a file. Each read_ function leaves `value` alone where the key is absent and throws
/// Error where it has another type or lies out of range.
class TomlReader {
 public:
  /// `name` is the table's, for messages; empty for the file itself. keys: is told what is asked
  /// for, of this table and of those in it, and must outlive them; null: nobody is.
  TomlReader(std::string file, const toml::table& table, std::string name,
             TomlKeys* keys = nullptr);

  void read(std::string_view key, std::string& value);
  void read(std::string_view key, bool& value);
  /// Within [minimum, maximum].
  void read(std::string_view key, int& value, int minimum, int maximum);
  void read(std::string_view key, std::optional<int>& value, int minimum, int maximum);
  void read(std::string_view key, std::int64_t& value, std::int64_t minimum, std::int64_t maximum);
  /// Finite and within [minimum, maximum]; a whole number will do.
  void read(std::string_view key, double& value, double minimum, double maximum);
  void read(std::string_view key, std::optional<double>& value, double minimum, double maximum);
  /// Arrays of as many numbers as the vector has components, each of them as above.
  void read(std::string_view key, Vec2& value, double minimum, double maximum);
  void read(std::string_view key, std::optional<Vec2>& value, double minimum, double maximum);
  void read(std::string_view key, Vec3& value, double minimum, double maximum);
  /// One of `choices`, which are in ascending order.
  void read(std::string_view key, int& value, const std::vector<int>& choices);
  /// One of `words`.
  template <typename Value, std::size_t count>
  void read(std::string_view key, Value& value, const std::array<Word<Value>, count>& words) {
    std::vector<std::string_view> known;
    std::optional<std::string> default_text;
    known.reserve(count);
    for (const Word<Value>& word : words) {
      known.push_back(word.text);
      if (word.value == value) {
        default_text = word.text;
      }
    }
    if (const std::size_t found = find_word(key, known, default_text); found < count) {
      value = words[found].value;
    }
  }

  /// `key`, or the name that it had in earlier versions if the table has only that. The latter
  /// leaves a note.
  std::string_view present_name(std::string_view key, std::string_view former);

  /// A line for each key that stands under its former name, of this table and all others of the
  /// file that were read.
  const std::vector<std::string>& notes() const { return *notes_; }

  bool has(std::string_view key) const { return table_->contains(key); }
  bool is_array(std::string_view key) const { return has(key) && table_->get(key)->is_array(); }
  /// Throws Error if the key is absent.
  void require(std::string_view key) const;

  /// A string and where it stands.
  struct Text {
    std::string value;
    toml::source_region source;
  };
  /// A non-empty array of at most 1000 strings, none twice; no strings if the key is absent.
  std::vector<Text> texts(std::string_view key);
  /// The same strings of a key that must be there: throws Error if it is absent.
  std::vector<Text> require_texts(std::string_view key);
  /// Throws Error if the key is absent or empty.
  std::string require_text(std::string_view key);

  /// The table `key`, or an empty one.
  TomlReader table(std::string_view key);
  /// The array of at most 1000 tables `key`, or none.
  std::vector<TomlReader> tables(std::string_view key);

  /// To be called after everything was read: throws Error for the first key that nothing asked for.
  void reject_unknown_keys() const;

  [[noreturn]] void fail(const toml::source_region& source, const std::string& what,
                         const std::string& remedy) const;
  /// Where the key's value stands, or the table itself. The key must be there.
  const toml::source_region& source(std::string_view key) const {
    return table_->get(key)->source();
  }
  const toml::source_region& source() const { return table_->source(); }

 private:
  TomlReader inner(const toml::table& table, std::string_view key) const;
  /// Null if the key is absent.
  const toml::node* find(std::string_view key, const TomlKeyRule& rule);
  void read_whole(std::string_view key, std::int64_t& value, const TomlKeyRule& rule,
                  std::int64_t minimum, std::int64_t maximum);
  void read_number(std::string_view key, double& value, const TomlKeyRule& rule);
  std::string text_in(const toml::node& node, std::string_view key) const;
  void note_required(std::string_view key) const;
  void require_moderate_length(std::string_view key, const toml::array& array) const;
  std::string full_name(std::string_view key) const;
  /// The index in `known` of the text under `key`; known.size() if the key is absent.
  std::size_t find_word(std::string_view key, const std::vector<std::string_view>& known,
                        const std::optional<std::string>& default_text);
  template <typename Vector>
  void read_vector(std::string_view key, Vector& value, double minimum, double maximum,
                   const std::optional<std::string>& default_text);

  std::string file_;
  const toml::table* table_;
  std::string name_;
  TomlKeys* keys_;
  std::set<std::string, std::less<>> asked_;
  std::shared_ptr<std::vector<std::string>> notes_;  ///< shared by all tables of the file
};

}  // namespace foveola
