// What single keys of the experimenter's ask for, and what is asked back first.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace foveola::study {

/// A key typed in a terminal.
struct TypedKey {
  enum class Kind { character, enter, escape, erase };
  Kind kind = Kind::character;
  char32_t character = 0;  ///< of that kind
};

class KeyPrompt {
 public:
  /// Returns the line for parse_console_line() that the key completes, if it does. A note and a
  /// reason are typed first; what cannot be taken back is confirmed by Enter, or let go by Escape.
  /// is_paused: the session is, and the key for a pause ends it.
  std::optional<std::string> follow(const TypedKey& key, bool is_paused);

  /// What is asked back, with what was typed so far. Empty: nothing is.
  std::string question() const;

 private:
  struct Asked {
    std::string command;   ///< "note"
    std::string question;  ///< "A note for the record:"
    bool takes_text = false;
    std::string text;
  };

  std::optional<std::string> begin(char32_t key, bool is_paused);
  std::optional<std::string> end();

  std::optional<Asked> asked_;
};

/// One line that names all keys.
std::string key_names(bool is_paused);

/// A line for each key: what it does.
std::vector<std::string> key_help();

}  // namespace foveola::study
