// Lays out the experimenter's screen as lines of text for any terminal size, and edits the typed
// line.
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
  std::span<const std::string> said;  ///< messages and replies, the newest last
  std::string typed;                  ///< the command being typed
};

struct ScreenSize {
  std::size_t columns = 80;
  std::size_t rows = 24;
};

/// Returns as many lines as the screen has rows, none longer than its columns: the title, the
/// status, its warnings, the newest messages, and last the commands or the typed line. Few rows
/// leave out messages first.
std::vector<ScreenLine> lay_out_screen(const ScreenContent& content, const ScreenSize& size);

/// Wraps a text into lines of at most `columns` characters, at spaces if possible.
std::vector<std::string> wrapped(std::string_view text, std::size_t columns);

struct TypedKey {
  enum class Kind { character, enter, escape, erase };
  Kind kind = Kind::character;
  char32_t character = 0;  ///< the character, if the kind is a character
  bool is_pasted = false;
};

/// A line for parse_console_line().
struct EnteredLine {
  std::string text;
  bool is_pasted = false;  ///< whether any part of it was pasted
};

class CommandEntry {
 public:
  /// Handles a key. Returns the line if the key is Enter; a pasted line break is a space. Escape
  /// clears the line.
  std::optional<EnteredLine> follow(const TypedKey& key);

  const std::string& typed() const { return line_.text; }

 private:
  EnteredLine line_;
};

}  // namespace foveola::study
