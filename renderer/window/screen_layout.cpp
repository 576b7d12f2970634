#include "renderer/window/screen_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/window/screen_fields.h"

namespace foveola {
namespace {

// In heights of a line of text.
constexpr float margin = 1.2F;
constexpr float widest_column = 34.0F;  // about most_line_characters
constexpr float progress_height = 0.3F;
constexpr float above_content = 2.3F;
constexpr float above_keys = 1.0F;
constexpr float band_padding = 0.8F;

/// The rectangle of `size` around `middle`, moved as far as it takes to lie in `whole`.
ScreenRect rect_within(const ScreenRect& whole, const Vec2& middle, const Vec2& size) {
  const Vec2 low = glm::clamp(middle - 0.5F * size, whole.low, whole.high - size);
  return {.low = low, .high = low + size};
}

/// An empty column in the middle of a page.
ScreenColumn column_of(const ScreenPlace& place, const TextWidth& width_of) {
  const float text_px = text_height_px(place);
  const float width_px =
      std::min(place.page.size().x - 2.0F * margin * text_px, widest_column * text_px);
  const float middle_px = 0.5F * (place.page.low.x + place.page.high.x);
  return {middle_px - 0.5F * width_px, width_px, text_px, width_of};
}

void add_title(ScreenColumn& column, const std::string& title) {
  if (!title.empty()) {
    column.write(title, TextFace::title, Ink::text);
    column.leave(0.5F);
  }
}

void add_content(ScreenColumn& column, const ScreenPage& screen) {
  add_title(column, screen.title);
  for (const std::string& paragraph : screen.paragraphs) {
    column.write(paragraph, TextFace::body, Ink::text);
    column.leave(0.5F);
  }
  for (const ScreenField& field : screen.fields) {
    add_field(column, field);
    column.leave(1.0F);
  }
}

/// Where the content's top stands, so that what has the focus is between top_px and bottom_px.
float content_top_px(const ScreenColumn& content, float top_px, float bottom_px, float slack) {
  const float room_px = bottom_px - top_px;
  const float too_much_px = content.bottom_px() - room_px;
  if (too_much_px <= 0.0F) {
    return top_px - slack * too_much_px;
  }
  const auto& focus = content.focus();
  const float wanted_px = focus ? 0.5F * (focus->low.y + focus->high.y - room_px) : 0.0F;
  return top_px - std::clamp(wanted_px, 0.0F, too_much_px);
}

ScreenRect moved(const ScreenRect& rect, float down_px) {
  const Vec2 low = glm::round(rect.low + Vec2(0.0F, down_px));
  return {.low = low, .high = low + rect.size()};
}

/// Adds what lies wholly between top_px and bottom_px once it is moved. Returns whether something
/// was left out above, and below.
std::pair<bool, bool> add_moved(ScreenLayout& layout, const ScreenLayout& more, float down_px,
                                float top_px, float bottom_px) {
  constexpr float rounding_px = 1.0F;
  std::pair<bool, bool> left_out{false, false};
  const auto is_inside = [&](const ScreenRect& rect) {
    left_out.first = left_out.first || rect.low.y < top_px - rounding_px;
    left_out.second = left_out.second || rect.high.y > bottom_px + rounding_px;
    return rect.low.y >= top_px - rounding_px && rect.high.y <= bottom_px + rounding_px;
  };
  for (PlacedShape shape : more.shapes) {
    shape.rect = moved(shape.rect, down_px);
    if (is_inside(shape.rect)) {
      layout.shapes.push_back(shape);
    }
  }
  for (PlacedText text : more.texts) {
    text.rect = moved(text.rect, down_px);
    if (is_inside(text.rect)) {
      layout.texts.push_back(std::move(text));
    }
  }
  return left_out;
}

/// Shows that there is more: a triangle in the middle of the page, around y_px.
void add_more_mark(ScreenLayout& layout, PlacedShape::Kind kind, const ScreenPlace& place,
                   float y_px) {
  const Vec2 size = text_height_px(place) * Vec2(0.8F, 0.5F);
  const Vec2 middle(0.5F * (place.page.low.x + place.page.high.x), y_px);
  layout.shapes.push_back({.kind = kind,
                           .ink = Ink::focus,
                           .rect = {.low = middle - 0.5F * size, .high = middle + 0.5F * size}});
}

/// slack: how much of what is left free stands above the content.
void add_scrolled(ScreenLayout& layout, const ScreenColumn& content, const ScreenPlace& place,
                  float top_px, float bottom_px, float slack) {
  // What is drawn around a field reaches over it.
  const float reach_px = 0.4F * content.text_px();
  const float down_px = content_top_px(content, top_px, bottom_px, slack);
  const auto [is_above, is_below] =
      add_moved(layout, content.layout(), down_px, top_px - reach_px, bottom_px + reach_px);
  if (is_above) {
    add_more_mark(layout, PlacedShape::Kind::triangle_up, place, top_px - 0.7F * content.text_px());
  }
  if (is_below) {
    add_more_mark(layout, PlacedShape::Kind::triangle_down, place,
                  bottom_px + 0.7F * content.text_px());
  }
}

void add_progress(ScreenLayout& layout, const ScreenPlace& place, const ScreenColumn& column,
                  double progress) {
  ScreenColumn bar = column;
  const Vec2 size(column.width_px(), progress_height * column.text_px());
  const Vec2 done(static_cast<float>(std::clamp(progress, 0.0, 1.0)) * size.x, size.y);
  bar.put_shape(PlacedShape::Kind::box, Vec2(0.0F), done, Ink::quiet);
  bar.put_shape(PlacedShape::Kind::box, Vec2(0.0F), size, Ink::outline, 0.25F * size.y);
  const float top_px = place.page.low.y + margin * column.text_px();
  add_moved(layout, bar.layout(), top_px, place.page.low.y, place.page.high.y);
}

ScreenLayout lay_out_page(const ScreenPage& screen, const ScreenPlace& place,
                          const TextWidth& width_of) {
  ScreenLayout layout;
  layout.shapes.push_back({.ink = Ink::ground, .rect = place.view});
  const ScreenColumn empty = column_of(place, width_of);
  const float text_px = empty.text_px();
  if (screen.progress) {
    add_progress(layout, place, empty, *screen.progress);
  }
  ScreenColumn keys = empty;
  keys.write(screen.keys, TextFace::body, Ink::quiet);
  const float keys_px = place.page.high.y - margin * text_px - keys.bottom_px();
  add_moved(layout, keys.layout(), keys_px, place.page.low.y, place.page.high.y);
  ScreenColumn content = empty;
  add_content(content, screen);
  // Forms stand still from question to question; what is only read stands where the eye rests.
  const float slack = screen.fields.empty() ? 0.4F : 0.0F;
  add_scrolled(layout, content, place, place.page.low.y + above_content * text_px,
               keys_px - above_keys * text_px, slack);
  return layout;
}

ScreenLayout lay_out_band(const ScreenPage& screen, const ScreenPlace& place,
                          const TextWidth& width_of) {
  ScreenLayout layout;
  ScreenColumn content = column_of(place, width_of);
  add_content(content, screen);
  if (!screen.keys.empty()) {
    content.write(screen.keys, TextFace::body, Ink::quiet);
  }
  const float padding_px = band_padding * content.text_px();
  const float bottom_px = place.page.high.y - padding_px;
  const float top_px = std::max(bottom_px - content.bottom_px(), place.page.low.y + padding_px);
  layout.shapes.push_back({.ink = Ink::ground,
                           .rect = {.low = glm::round(Vec2(place.page.low.x, top_px - padding_px)),
                                    .high = place.page.high}});
  add_scrolled(layout, content, place, top_px, bottom_px, 0.0F);
  return layout;
}

Ink reversed(Ink ink) {
  switch (ink) {
    case Ink::ground:
      return Ink::text;
    case Ink::text:
    case Ink::quiet:
      return Ink::ground;
    default:
      return ink;
  }
}

void reverse(ScreenLayout& layout) {
  for (PlacedShape& shape : layout.shapes) {
    shape.ink = reversed(shape.ink);
  }
  for (PlacedText& text : layout.texts) {
    text.ink = reversed(text.ink);
  }
}

}  // namespace

Vec3 color_of(Ink ink) {
  switch (ink) {
    case Ink::text:
      return {0.949F, 0.949F, 0.933F};
    case Ink::quiet:
      return {0.769F, 0.804F, 0.839F};
    case Ink::focus:
      return {1.0F, 0.788F, 0.251F};
    case Ink::fault:
      return {1.0F, 0.671F, 0.639F};
    case Ink::chosen:
      return {0.604F, 0.820F, 1.0F};
    case Ink::outline:
      return {0.486F, 0.541F, 0.592F};
    case Ink::ground:
      break;
  }
  return {0.078F, 0.094F, 0.114F};
}

ScreenPlace screen_place(const WindowPart& part, int framebuffer_height, bool is_headset,
                         const Vec2& straight_ahead) {
  const Vec2 size(part.size);
  const auto top = static_cast<float>(framebuffer_height - part.origin.y - part.size.y);
  const Vec2 low(static_cast<float>(part.origin.x), top);
  const ScreenRect view{.low = low, .high = low + size};
  return {.view = view,
          .page = is_headset ? rect_within(view, low + straight_ahead * size, 0.5F * size) : view};
}

float text_height_px(const ScreenPlace& place) {
  const Vec2 size = place.page.size();
  return std::max(1.0F, std::floor(std::min(size.y / 28.0F, size.x / 27.0F)));
}

ScreenLayout lay_out(const ScreenPage& screen, const ScreenPlace& place,
                     const TextWidth& width_of) {
  ScreenLayout layout = screen.covers_picture ? lay_out_page(screen, place, width_of)
                                              : lay_out_band(screen, place, width_of);
  if (screen.is_signal) {
    reverse(layout);
  }
  return layout;
}

}  // namespace foveola
