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
  std::vector<std::string> labels;    ///< of a scale's points or a choice's options
  std::optional<std::size_t> chosen;  ///< of them
  std::string typed;                  ///< of a line or a text
  std::string fault;                  ///< why it is no answer; empty if there is nothing to say
  bool has_focus = false;
};

struct Screen {
  std::string title;
  std::vector<std::string> paragraphs;
  std::vector<ScreenField> fields;
  std::string keys;                ///< the line at the bottom: which keys do what
  std::optional<double> progress;  ///< of the session, in [0, 1]
  bool covers_picture = true;      ///< otherwise a band at the bottom, the picture above it
};

}  // namespace foveola
