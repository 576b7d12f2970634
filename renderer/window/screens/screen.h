// Data of a text page with fields, shown over the picture or instead of it.
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
  std::string note;                   ///< remark below the typed text; may be empty
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
  /// If false, the text is in a band at the bottom. Text without fields that is too long for it
  /// begins in a second band at the top.
  bool covers_picture = true;
  bool is_signal = false;  ///< bright instead of dark, as a signal to someone waiting
};

/// Maximum number of lines of text, including empty ones between paragraphs, that fit a page that
/// covers the picture in any window and headset, with a one-line title and key line.
inline constexpr std::size_t max_screen_lines = 12;
/// Minimum number of characters of running text in a full line.
inline constexpr std::size_t screen_line_characters = 42;

}  // namespace foveola
