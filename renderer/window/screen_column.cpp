#include "renderer/window/screen_column.h"

namespace foveola {
namespace {

float face_scale(TextFace face) { return face == TextFace::title ? title_scale : 1.0F; }

/// How much of what is left beside a line stands before it.
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

LineWidth ScreenColumn::line_width(TextFace face) const {
  return [this, face](std::string_view line) { return (*width_of_)(face, line); };
}

void ScreenColumn::write(std::string_view text, TextFace face, Ink ink) {
  for (const std::string& line : wrapped(text, width_px_, line_width(face))) {
    put_line({0.0F, y_px_}, line, face, ink);
    leave(line_spacing * face_scale(face));
  }
}

void ScreenColumn::write_between(float left_px, float right_px, std::string_view text, Align align,
                                 Ink ink) {
  const float room_px = right_px - left_px;
  for (const std::string& line : wrapped(text, room_px, line_width(TextFace::body))) {
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
