// A page with words and fields, over the picture or instead of it, as plain values.
//
// It describes only the appearance, not the effects of keys.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace foveola {

struct ScreenField {
  enum class Kind {
    scale,   ///< points in a row, some with labels
    choice,  ///< options in a list
    line,    ///< a typed line
    text,    ///< typed words over several lines
  };
  Kind kind = Kind::scale;
  std::string question;
  /// A choice's options, or a scale's points: the text in a point and, after a line break, the
  /// words below it, as in "5\nnot at all".
  std::vector<std::string> labels;
  std::optional<std::size_t> chosen;  ///< index of the chosen option or point
  std::string typed;                  ///< typed content of a line or a text field
  std::string note;                   ///< on the typed content; may be empty
  std::string fault;                  ///< why the answer is invalid; may be empty
  bool has_focus = false;
};

/// All text is UTF-8, written from left to right, letter by letter.
struct ScreenPage {
  std::string title;
  std::vector<std::string> paragraphs;
  std::vector<ScreenField> fields;
  std::string keys;                ///< the line at the bottom, on keys
  std::optional<double> progress;  ///< the session's progress, in [0, 1]
  /// Otherwise a band at the bottom. Words without fields that would reach the picture's middle are
  /// in one at the top, too.
  bool covers_picture = true;
  bool is_signal = false;  ///< bright instead of dark, as a signal to someone waiting
};

/// Number of lines of words, including lines between paragraphs, that fit a screen that covers the
/// picture in any window and headset, beside one line each of title and keys. Longer text needs
/// more screens.
inline constexpr std::size_t screen_lines = 12;
/// Minimum number of characters of running text in a full line.
inline constexpr std::size_t screen_line_characters = 42;

}  // namespace foveola
