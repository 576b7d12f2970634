#include "renderer/window/screens/screen_column.h"

#include <algorithm>
#include <utility>

#include "renderer/base/text/utf8.h"

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
    return count_characters(line) <= max_line_characters && (*width_of_)(line) <= width_px_;
  }

  /// At least one character, even without room for any.
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

float face_scale(TextFace face) { return face == TextFace::title ? title_scale : 1.0F; }

/// Share of a line's free space before it.
float share_before(Align align) {
  switch (align) {
    case Align::center:
      return 0.5F;
    case Align::right:
      return 1.0F;
    case Align::left:
      break;
  }
  return 0.0F;
}

}  // namespace

std::vector<std::string> wrap_to_width(std::string_view text, float width_px,
                                       const LineWidth& width_of) {
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

LineWidth ScreenColumn::line_width(TextFace face) const {
  return [this, face](std::string_view line) { return (*width_of_)(face, line); };
}

void ScreenColumn::write(std::string_view text, TextFace face, Ink ink) {
  for (const std::string& line : wrap_to_width(text, width_px_, line_width(face))) {
    put_line({0.0F, y_px_}, line, face, ink);
    leave(line_spacing * face_scale(face));
  }
}

void ScreenColumn::write_between(float left_px, float right_px, std::string_view text, Align align,
                                 Ink ink) {
  const float room_px = right_px - left_px;
  for (const std::string& line : wrap_to_width(text, room_px, line_width(TextFace::body))) {
    const float before_px = share_before(align) * (room_px - line_width_px(line));
    put_line({left_px + before_px, y_px_}, line, TextFace::body, ink);
    leave(line_spacing);
  }
}

void ScreenColumn::put_line(const Vec2& low_px, std::string_view line, TextFace face, Ink ink) {
  if (line.empty()) {
    return;
  }
  const Vec2 size_px((*width_of_)(face, line), face_scale(face) * text_px_);
  layout_.texts.push_back(
      {.face = face, .ink = ink, .rect = rect(low_px, size_px), .line = std::string(line)});
}

void ScreenColumn::put_shape(PlacedShape::Kind kind, const Vec2& low_px, const Vec2& size_px,
                             Ink ink, float outline_px) {
  layout_.shapes.push_back(
      {.kind = kind, .ink = ink, .rect = rect(low_px, size_px), .outline_px = outline_px});
}

void ScreenColumn::put_frame(const Vec2& low_px, const Vec2& size_px, Ink ink, float outline_px) {
  put_shape(PlacedShape::Kind::box, low_px, size_px, ink, outline_px);
  layout_.shapes.back().is_frame = true;
}

void ScreenColumn::put_focus(const Vec2& low_px, const Vec2& size_px) {
  focus_ = rect(low_px, size_px);
}

ScreenRect ScreenColumn::rect(const Vec2& low_px, const Vec2& size_px) const {
  const Vec2 low = Vec2(left_px_, 0.0F) + low_px;
  return {.low = low, .high = low + size_px};
}

}  // namespace foveola
