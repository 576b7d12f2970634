// The line that the experimenter types in the terminal, key by key.
#pragma once

#include <optional>
#include <string>

namespace foveola::study {

/// A key typed in a terminal.
struct TypedKey {
  enum class Kind { character, enter, escape, erase };
  Kind kind = Kind::character;
  char32_t character = 0;  ///< of that kind
  bool is_pasted = false;
};

/// A line for parse_console_line().
struct EnteredLine {
  std::string text;
  bool is_pasted = false;  ///< any of it
};

class CommandEntry {
 public:
  /// Returns the line that the key ends: Enter alone does, a pasted one is a space. Escape clears
  /// what was typed.
  std::optional<EnteredLine> follow(const TypedKey& key);

  const std::string& typed() const { return line_.text; }

 private:
  EnteredLine line_;
};

}  // namespace foveola::study
