// The experimenter's screen as lines of text: what stands where, at any size of the terminal, and
// the line that is typed in it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "study/console/session_status.h"

namespace foveola::study {

enum class LineLook { plain, title, warning, typed };

struct ScreenLine {
  std::string text;
  LineLook look = LineLook::plain;
};

struct ScreenContent {
  SessionStatus status;
  std::span<const std::string> said;  ///< what happened and was answered, the newest last
  std::string typed;                  ///< the command that is being typed
};

struct ScreenSize {
  std::size_t columns = 80;
  std::size_t rows = 24;
};

/// As many lines as the screen has rows, none with more characters than it has columns: the title,
/// how the session stands, its warnings, the newest of what was said, and last the commands, or
/// what is typed in their place. Where rows are few, what was said goes first.
std::vector<ScreenLine> screen_lines(const ScreenContent& content, const ScreenSize& size);

/// A text in lines of at most `columns` characters, broken at spaces where there are any.
std::vector<std::string> wrapped(std::string_view text, std::size_t columns);

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
