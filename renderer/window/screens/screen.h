// A page with words and fields, over the picture or instead of it, as plain values.
//
// It only says what is to be seen; what keys and words do to it is for others to decide.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace foveola {

struct ScreenField {
  enum class Kind {
    scale,   ///< points in a row, each with a label or none
    choice,  ///< options in a list
    line,    ///< a typed line
    text,    ///< typed words over several lines
  };
  Kind kind = Kind::scale;
  std::string question;
  /// A choice's options, or a scale's points: what stands in a point and, after a line break,
  /// the words below it, as in "5\nnot at all".
  std::vector<std::string> labels;
  std::optional<std::size_t> chosen;  ///< index of the chosen option or point
  std::string typed;                  ///< what was typed into a line or a text field
  std::string note;                   ///< on what was typed; empty if there is nothing to say
  std::string fault;                  ///< why it is no answer; empty if there is nothing to say
  bool has_focus = false;
};

/// All text is UTF-8, written from left to right, letter by letter.
struct ScreenPage {
  std::string title;
  std::vector<std::string> paragraphs;
  std::vector<ScreenField> fields;
  std::string keys;                ///< the line at the bottom: which keys do what
  std::optional<double> progress;  ///< the session's progress, in [0, 1]
  /// Otherwise a band at the bottom; words without fields that would reach the picture's middle
  /// stand in one at the top, too.
  bool covers_picture = true;
  bool is_signal = false;  ///< bright instead of dark, for who waits for it to change
};

/// What a screen that covers the picture has room for in any window and headset, beside a title and
/// keys of a line each: so many lines of words, a line between paragraphs included. What is longer
/// goes on more than one screen.
inline constexpr std::size_t screen_lines = 12;
/// The fewest characters of running text that fill a line.
inline constexpr std::size_t screen_line_characters = 42;

}  // namespace foveola
