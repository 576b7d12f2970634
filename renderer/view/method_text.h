// Parses the text of view methods, as in protocols, command lines and records.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "renderer/base/text/words.h"

namespace foveola {

/// Reads "NAME" or "NAME:KEY=VALUE,KEY=VALUE", setting by setting. Values with a comma or a plus
/// are in double quotes.
class MethodText {
 public:
  /// Throws Error if a setting is not KEY=VALUE or is given twice.
  explicit MethodText(std::string_view text);

  const std::string& name() const { return name_; }

  /// A number in [minimum, maximum]. Throws Error if the value is not one.
  double number(std::string_view key, double fallback, double minimum, double maximum);
  /// A number as above; nullopt if the setting is absent.
  std::optional<double> number(std::string_view key, double minimum, double maximum);
  /// A required value. Throws Error that names it `what` if it is absent.
  std::string required(std::string_view key, std::string_view what);
  /// One of `known`. Throws Error for another value.
  std::string word(std::string_view key, std::string_view fallback,
                   const std::vector<std::string>& known);
  template <typename Value, std::size_t count>
  Value word(std::string_view key, std::string_view fallback,
             const std::array<Word<Value>, count>& words) {
    return value_of(words, word(key, fallback, texts_of(words)));
  }

  /// Throws Error for a setting that was never requested. To be called after everything was read.
  void reject_unknown_settings() const;
  [[noreturn]] void fail(const std::string& what, const std::string& remedy) const;

 private:
  /// Null if the setting is absent; find also notes the request.
  const std::string* find(std::string_view key);
  const std::string* lookup(std::string_view key) const;

  std::string text_;
  std::string name_;
  std::vector<std::pair<std::string, std::string>> settings_;
  std::vector<std::string> asked_;
};

/// A part of "hybrid:WEIGHT*METHOD+WEIGHT*METHOD". A hybrid within a hybrid is quoted.
struct HybridPart {
  double weight = 1.0;      ///< positive
  std::string_view method;  ///< points into the whole text, without the surrounding quotes
};

bool is_hybrid(std::string_view method);
/// The parts of a hybrid, at least one. Throws Error for empty weights or methods.
std::vector<HybridPart> hybrid_parts(std::string_view method);

}  // namespace foveola
