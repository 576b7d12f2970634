#include "renderer/window/wrapped_text.h"

#include <algorithm>
#include <utility>

#include "renderer/base/utf8.h"

namespace foveola {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = std::min(text.find(separator), text.size());
    parts.push_back(text.substr(0, end));
    if (end == text.size()) {
      return parts;
    }
    text.remove_prefix(end + 1);
  }
}

/// Fills lines word by word.
class LineFiller {
 public:
  LineFiller(float width_px, const LineWidth& width_of)
      : width_px_(width_px), width_of_(&width_of) {}

  void add_word(std::string_view word) {
    std::string longer = line_;
    if (!longer.empty()) {
      longer += ' ';
    }
    longer += word;
    if (fits(longer)) {
      line_ = std::move(longer);
      return;
    }
    if (!line_.empty()) {
      end_line();
    }
    while (!fits(word) && count_characters(word) > 1) {
      const std::size_t bytes = bytes_that_fit(word);
      line_ = word.substr(0, bytes);
      end_line();
      word.remove_prefix(bytes);
    }
    line_ = word;
  }

  void end_line() {
    lines_.push_back(line_);
    line_.clear();
  }

  std::vector<std::string> take() { return std::move(lines_); }

 private:
  bool fits(std::string_view line) const {
    return count_characters(line) <= most_line_characters && (*width_of_)(line) <= width_px_;
  }

  /// The piece has one character at least, even where there is no room for any.
  std::size_t bytes_that_fit(std::string_view word) const {
    std::size_t characters = 1;
    while (fits(word.substr(0, bytes_of_first(word, characters + 1)))) {
      ++characters;
    }
    return bytes_of_first(word, characters);
  }

  float width_px_;
  const LineWidth* width_of_;
  std::string line_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> wrapped(std::string_view text, float width_px, const LineWidth& width_of) {
  LineFiller filler(width_px, width_of);
  for (const std::string_view line : split(text, '\n')) {
    for (const std::string_view word : split(line, ' ')) {
      filler.add_word(word);
    }
    filler.end_line();
  }
  return filler.take();
}

float widest_word_px(std::string_view text, const LineWidth& width_of) {
  float widest = 0.0F;
  for (const std::string_view line : split(text, '\n')) {
    for (const std::string_view word : split(line, ' ')) {
      widest = std::max(widest, width_of(word));
    }
  }
  return widest;
}

}  // namespace foveola
