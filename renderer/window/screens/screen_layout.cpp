#include "renderer/window/screens/screen_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "renderer/base/transformed.h"
#include "renderer/window/screens/screen_fields.h"

namespace foveola {
namespace {

// In heights of a line of text.
constexpr float margin = 1.2F;
constexpr float widest_column = 34.0F;  // about max_line_characters
constexpr float progress_height = 0.3F;
constexpr float above_content = 2.7F;
constexpr float above_keys = 1.2F;
constexpr float band_padding = 0.8F;
/// Half width of the free centre of a page, in heights of the page: words over a picture leave it
/// free.
constexpr float free_middle = 0.08F;

/// The rectangle of `size` around `middle`, moved as little as needed to lie in `whole`.
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

void leave_before_next(ScreenColumn& column, float lines) {
  column.leave(column.bottom_px() > 0.0F ? lines : 0.0F);
}

void add_content(ScreenColumn& column, const ScreenPage& screen) {
  if (!screen.title.empty()) {
    column.write(screen.title, TextFace::title, Ink::text);
  }
  for (const std::string& paragraph : screen.paragraphs) {
    leave_before_next(column, 0.5F);
    column.write(paragraph, TextFace::body, Ink::text);
  }
  for (const ScreenField& field : screen.fields) {
    leave_before_next(column, &field == &screen.fields.front() ? 0.5F : 1.0F);
    add_field(column, field);
  }
}

/// Top and bottom of the visible part.
struct Span {
  float top_px = 0.0F;
  float bottom_px = 0.0F;

  bool holds(const ScreenRect& rect) const {
    constexpr float rounding_px = 1.0F;
    return rect.low.y >= top_px - rounding_px && rect.high.y <= bottom_px + rounding_px;
  }
};

/// The content's top, such that the focus is in `room`.
float content_top_px(const ScreenColumn& content, const Span& room, float slack) {
  const float room_px = room.bottom_px - room.top_px;
  const float too_much_px = content.bottom_px() - room_px;
  if (too_much_px <= 0.0F) {
    return room.top_px - slack * too_much_px;
  }
  const auto& focus = content.focus();
  const float wanted_px = focus ? 0.5F * (focus->low.y + focus->high.y - room_px) : 0.0F;
  return room.top_px - std::clamp(wanted_px, 0.0F, too_much_px);
}

ScreenLayout moved(ScreenLayout layout, float down_px) {
  const auto move = [&](ScreenRect& rect) {
    const Vec2 low = glm::round(rect.low + Vec2(0.0F, down_px));
    rect = {.low = low, .high = low + rect.size()};
  };
  for (PlacedShape& shape : layout.shapes) {
    move(shape.rect);
  }
  for (PlacedText& text : layout.texts) {
    move(text.rect);
  }
  return layout;
}

/// Indivisible parts: lines, and shapes except frames.
std::vector<ScreenRect> things_of(const ScreenLayout& layout) {
  std::vector<ScreenRect> things = transformed(layout.texts, &PlacedText::rect);
  for (const PlacedShape& shape : layout.shapes) {
    if (!shape.is_frame) {
      things.push_back(shape.rect);
    }
  }
  return things;
}

/// Narrows `span` so that its ends cut no thing. Things beside one that is left out are left out
/// with it.
Span span_between_things(Span span, const std::vector<ScreenRect>& things) {
  const auto crosses = [](const ScreenRect& rect, float y_px) {
    return rect.low.y < y_px - 1.0F && rect.high.y > y_px + 1.0F;
  };
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (const ScreenRect& thing : things) {
      if (crosses(thing, span.bottom_px)) {
        span.bottom_px = thing.low.y;
        is_changed = true;
      }
      if (crosses(thing, span.top_px)) {
        span.top_px = thing.high.y;
        is_changed = true;
      }
    }
  }
  return span;
}

void add(ScreenLayout& layout, const ScreenLayout& more) {
  layout.shapes.insert(layout.shapes.end(), more.shapes.begin(), more.shapes.end());
  layout.texts.insert(layout.texts.end(), more.texts.begin(), more.texts.end());
}

/// Adds the things in `span`, and the frames' parts in it.
void add_shown(ScreenLayout& layout, const ScreenLayout& more, const Span& span) {
  for (const PlacedText& text : more.texts) {
    if (span.holds(text.rect)) {
      layout.texts.push_back(text);
    }
  }
  for (PlacedShape shape : more.shapes) {
    if (shape.is_frame) {
      shape.rect.low.y = std::max(shape.rect.low.y, span.top_px);
      shape.rect.high.y = std::min(shape.rect.high.y, span.bottom_px);
    }
    if (span.holds(shape.rect) && shape.rect.low.y < shape.rect.high.y) {
      layout.shapes.push_back(shape);
    }
  }
}

/// Indicates more content: a triangle in the middle of the page, around y_px.
void add_more_mark(ScreenLayout& layout, PlacedShape::Kind kind, const ScreenPlace& place,
                   float y_px) {
  const Vec2 size = text_height_px(place) * Vec2(0.8F, 0.5F);
  const Vec2 middle(0.5F * (place.page.low.x + place.page.high.x), y_px);
  layout.shapes.push_back({.kind = kind,
                           .ink = Ink::focus,
                           .rect = {.low = middle - 0.5F * size, .high = middle + 0.5F * size}});
}

/// slack: share of the free space above the content.
void add_scrolled(ScreenLayout& layout, const ScreenColumn& content, const ScreenPlace& place,
                  const Span& room, float slack) {
  const float text_px = content.text_px();
  const ScreenLayout all = moved(content.layout(), content_top_px(content, room, slack));
  const std::vector<ScreenRect> things = things_of(all);
  const Span shown = span_between_things(room, things);
  // Frames extend a little beyond their content.
  add_shown(layout, all, {shown.top_px - 0.4F * text_px, shown.bottom_px + 0.4F * text_px});
  const auto is_any = [&](auto is_outside) { return std::ranges::any_of(things, is_outside); };
  if (is_any([&](const ScreenRect& rect) { return rect.low.y < shown.top_px - 1.0F; })) {
    add_more_mark(layout, PlacedShape::Kind::triangle_up, place, room.top_px - 0.8F * text_px);
  }
  if (is_any([&](const ScreenRect& rect) { return rect.high.y > shown.bottom_px + 1.0F; })) {
    add_more_mark(layout, PlacedShape::Kind::triangle_down, place, room.bottom_px + 0.8F * text_px);
  }
}

void add_progress(ScreenLayout& layout, const ScreenPlace& place, const ScreenColumn& column,
                  double progress) {
  ScreenColumn bar = column;
  const Vec2 size(column.width_px(), progress_height * column.text_px());
  const Vec2 done(static_cast<float>(std::clamp(progress, 0.0, 1.0)) * size.x, size.y);
  bar.put_shape(PlacedShape::Kind::box, Vec2(0.0F), done, Ink::quiet);
  bar.put_shape(PlacedShape::Kind::box, Vec2(0.0F), size, Ink::outline, 0.25F * size.y);
  add(layout, moved(bar.layout(), place.page.low.y + margin * column.text_px()));
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
  add(layout, moved(keys.layout(), keys_px));
  ScreenColumn content = empty;
  add_content(content, screen);
  // Forms keep their place from question to question; text alone is placed where the eye rests.
  const float slack = screen.fields.empty() ? 0.4F : 0.0F;
  add_scrolled(layout, content, place,
               {place.page.low.y + above_content * text_px, keys_px - above_keys * text_px}, slack);
  return layout;
}

ScreenColumn band_content(const ScreenPage& screen, const ScreenPlace& place,
                          const TextWidth& width_of) {
  ScreenColumn content = column_of(place, width_of);
  add_content(content, screen);
  if (!screen.keys.empty()) {
    leave_before_next(content, screen.fields.empty() ? 0.5F : 1.0F);
    content.write(screen.keys, TextFace::body, Ink::quiet);
  }
  return content;
}

/// Words that would reach the centre, where people look, are split above and below it: in the upper
/// part the title and the first paragraphs, as few as possible.
struct BandParts {
  ScreenPage upper;
  ScreenPage lower;
};

BandParts parts_around_middle(const ScreenPage& screen, const ScreenPlace& place,
                              const TextWidth& width_of) {
  const float text_px = text_height_px(place);
  const float room_px = (0.5F - free_middle) * place.page.size().y - 2.0F * band_padding * text_px;
  BandParts parts{.lower = screen};
  while (screen.fields.empty() && !parts.lower.paragraphs.empty() &&
         band_content(parts.lower, place, width_of).bottom_px() > room_px) {
    std::vector<std::string>& lower = parts.lower.paragraphs;
    if (!parts.lower.title.empty()) {
      parts.upper.title = std::exchange(parts.lower.title, {});
    } else {
      parts.upper.paragraphs.push_back(lower.front());
      lower.erase(lower.begin());
    }
  }
  return parts;
}

ScreenLayout lay_out_upper_band(const ScreenPage& screen, const ScreenPlace& place,
                                const TextWidth& width_of) {
  ScreenLayout layout;
  const ScreenColumn content = band_content(screen, place, width_of);
  if (content.bottom_px() <= 0.0F) {
    return layout;
  }
  const float padding_px = band_padding * content.text_px();
  const float top_px = place.page.low.y + padding_px;
  const float bottom_px = top_px + content.bottom_px();
  layout.shapes.push_back(
      {.ink = Ink::ground,
       .rect = {.low = place.page.low,
                .high = glm::round(Vec2(place.page.high.x, bottom_px + padding_px))}});
  add_scrolled(layout, content, place, {top_px, bottom_px}, 0.0F);
  return layout;
}

ScreenLayout lay_out_lower_band(const ScreenPage& screen, const ScreenPlace& place,
                                const TextWidth& width_of) {
  ScreenLayout layout;
  const ScreenColumn content = band_content(screen, place, width_of);
  const float padding_px = band_padding * content.text_px();
  const float bottom_px = place.page.high.y - padding_px;
  const float top_px = std::max(bottom_px - content.bottom_px(), place.page.low.y + padding_px);
  layout.shapes.push_back({.ink = Ink::ground,
                           .rect = {.low = glm::round(Vec2(place.page.low.x, top_px - padding_px)),
                                    .high = place.page.high}});
  add_scrolled(layout, content, place, {top_px, bottom_px}, 0.0F);
  return layout;
}

ScreenLayout lay_out_band(const ScreenPage& screen, const ScreenPlace& place,
                          const TextWidth& width_of) {
  const BandParts parts = parts_around_middle(screen, place, width_of);
  ScreenLayout layout = lay_out_upper_band(parts.upper, place, width_of);
  add(layout, lay_out_lower_band(parts.lower, place, width_of));
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

ScreenPlace screen_place(const WindowPart& part, int framebuffer_height,
                         const std::optional<Vec2>& straight_ahead) {
  const Vec2 size(part.size);
  const auto top = static_cast<float>(framebuffer_height - part.origin.y - part.size.y);
  const Vec2 low(static_cast<float>(part.origin.x), top);
  const ScreenRect view{.low = low, .high = low + size};
  return {
      .view = view,
      .page = straight_ahead ? rect_within(view, low + *straight_ahead * size, 0.5F * size) : view};
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
