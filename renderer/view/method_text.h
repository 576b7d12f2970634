// View methods as people write them: in protocols, on the command line, in records.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "renderer/base/words.h"

namespace foveola {

/// Reads "NAME" or "NAME:KEY=VALUE,KEY=VALUE", setting by setting. A value that has a comma or a
/// plus in it stands in double quotes.
class MethodText {
 public:
  /// Throws Error where a setting is no KEY=VALUE or is given twice.
  explicit MethodText(std::string_view text);

  const std::string& name() const { return name_; }

  /// A number in [minimum, maximum]. Throws Error if the value is none.
  double number(std::string_view key, double fallback, double minimum, double maximum);
  /// A number as above, or empty where the setting is absent.
  std::optional<double> number(std::string_view key, double minimum, double maximum);
  /// A value that must be given: throws Error, calling it a `what`, if it is not.
  std::string required(std::string_view key, std::string_view what);
  /// One of `known`. Throws Error if the value is none of them.
  std::string word(std::string_view key, std::string_view fallback,
                   const std::vector<std::string>& known);
  template <typename Value, std::size_t count>
  Value word(std::string_view key, std::string_view fallback,
             const std::array<Word<Value>, count>& words) {
    return value_of(words, word(key, fallback, texts_of(words)));
  }

  /// To be called after everything was read: throws Error for a setting that nothing asked for.
  void reject_unknown_settings() const;
  [[noreturn]] void fail(const std::string& what, const std::string& remedy) const;

 private:
  /// Null where the setting is absent; find also notes that it was asked for.
  const std::string* find(std::string_view key);
  const std::string* lookup(std::string_view key) const;

  std::string text_;
  std::string name_;
  std::vector<std::pair<std::string, std::string>> settings_;
  std::vector<std::string> asked_;
};

/// A part of "hybrid:WEIGHT*METHOD+WEIGHT*METHOD". A hybrid within a hybrid stands in quotes.
struct HybridPart {
  double weight = 1.0;      ///< positive
  std::string_view method;  ///< points into the whole text, without the quotes around it
};

bool is_hybrid(std::string_view method);
/// At least one; empty weights and methods are refused. method: a hybrid. Throws Error.
std::vector<HybridPart> hybrid_parts(std::string_view method);

}  // namespace foveola
