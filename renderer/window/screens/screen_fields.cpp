#include "renderer/window/screens/screen_fields.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "renderer/base/text/utf8.h"

namespace foveola {
namespace {

using Kind = PlacedShape::Kind;

// In heights of a line of text.
constexpr float box_height = 1.6F;
constexpr float box_padding = 0.3F;
constexpr float between_words = 0.4F;
constexpr float frame_padding = 0.3F;
constexpr float frame_outline = 0.12F;
constexpr float box_outline = 0.07F;

/// A point of a scale: "5\nnot at all" is 5, with words.
struct ScalePoint {
  std::string name;
  std::string words;
  bool is_chosen = false;
};

ScalePoint scale_point(const std::string& label) {
  const std::size_t end = std::min(label.find('\n'), label.size());
  return {.name = label.substr(0, end),
          .words = end < label.size() ? label.substr(end + 1) : std::string()};
}

/// The left and right end of a point's words, in the column.
struct WordRoom {
  float left_px = 0.0F;
  float right_px = 0.0F;
  Align align = Align::center;

  float width_px() const { return right_px - left_px; }
};

/// Points of a scale side by side: those from `first` on, at most `most`.
class PointRow {
 public:
  PointRow(const ScreenColumn& column, const ScreenField& field, std::size_t first,
           std::size_t most)
      : text_px_(column.text_px()), cell_px_(column.width_px() / static_cast<float>(most)) {
    const std::size_t end = std::min(first + most, field.labels.size());
    for (std::size_t i = first; i < end; ++i) {
      points_.push_back(scale_point(field.labels[i]));
      points_.back().is_chosen = field.chosen == i;
      widest_name_px_ = std::max(widest_name_px_, column.line_width_px(points_.back().name));
    }
    const float wanted_px = std::max(box_height * text_px_, widest_name_px_ + 0.6F * text_px_);
    box_width_px_ = std::min(wanted_px, cell_px_ - 0.15F * text_px_);
  }

  /// Whether every box and every word has enough room.
  bool fits(const ScreenColumn& column) const {
    const LineWidth width_of = column.line_width(TextFace::body);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (widest_word_px(points_[i].words, width_of) > room_of(i).width_px()) {
        return false;
      }
    }
    return widest_name_px_ + 0.2F * text_px_ <= box_width_px_;
  }

  void add_to(ScreenColumn& column) const {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      put_box(column, i);
    }
    column.leave(box_height + 0.2F);
    add_words(column);
  }

 private:
  float middle_px(std::size_t i) const { return (static_cast<float>(i) + 0.5F) * cell_px_; }

  void put_box(ScreenColumn& column, std::size_t i) const {
    const bool is_chosen = points_[i].is_chosen;
    const Vec2 low(middle_px(i) - 0.5F * box_width_px_, column.bottom_px());
    const Vec2 size(box_width_px_, box_height * text_px_);
    column.put_shape(Kind::box, low, size, is_chosen ? Ink::chosen : Ink::outline,
                     is_chosen ? 0.0F : box_outline * text_px_);
    const float before_px = 0.5F * (box_width_px_ - column.line_width_px(points_[i].name));
    column.put_line(low + Vec2(before_px, box_padding * text_px_), points_[i].name, TextFace::body,
                    is_chosen ? Ink::ground : Ink::text);
  }

  void add_words(ScreenColumn& column) const {
    const float top_px = column.bottom_px();
    float bottom_px = top_px;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (points_[i].words.empty()) {
        continue;
      }
      const WordRoom room = room_of(i);
      column.set_bottom_px(top_px);
      column.write_between(room.left_px, room.right_px, points_[i].words, room.align, Ink::text);
      bottom_px = std::max(bottom_px, column.bottom_px());
    }
    column.set_bottom_px(bottom_px);
  }

  /// The space of a point's words: half of the way to the next words on each side. At the first and
  /// the last point they are aligned with the point if that gives them more room.
  WordRoom room_of(std::size_t i) const {
    const float gap_px = 0.5F * between_words * text_px_;
    const float left_px = border_px(i, -1) + gap_px;
    const float right_px = border_px(i, 1) - gap_px;
    const float before_px = middle_px(i) - left_px;
    const float after_px = right_px - middle_px(i);
    if (i == 0 && after_px > 1.5F * before_px) {
      return {middle_px(i) - 0.5F * box_width_px_, right_px, Align::left};
    }
    if (i + 1 == points_.size() && before_px > 1.5F * after_px) {
      return {left_px, middle_px(i) + 0.5F * box_width_px_, Align::right};
    }
    const float half_px = std::min(before_px, after_px);
    return {middle_px(i) - half_px, middle_px(i) + half_px, Align::center};
  }

  /// The end of a point's words to one side: the row's own, or halfway to the next words.
  float border_px(std::size_t i, int side) const {
    const auto count = static_cast<std::ptrdiff_t>(points_.size());
    for (auto k = static_cast<std::ptrdiff_t>(i) + side; k >= 0 && k < count; k += side) {
      if (!points_[static_cast<std::size_t>(k)].words.empty()) {
        return 0.5F * (middle_px(i) + middle_px(static_cast<std::size_t>(k)));
      }
    }
    return side < 0 ? 0.0F : cell_px_ * static_cast<float>(count);
  }

  float text_px_;
  float cell_px_;
  std::vector<ScalePoint> points_;
  float widest_name_px_ = 0.0F;
  float box_width_px_ = 0.0F;
};

/// The points in the fewest rows that fit; empty if none do. A short scale is not broken.
std::vector<PointRow> point_rows(const ScreenColumn& column, const ScreenField& field) {
  constexpr std::size_t longest_short_scale = 7;
  const std::size_t points = field.labels.size();
  const std::size_t max_rows = points > longest_short_scale ? 3 : 1;
  for (std::size_t count = 1; count <= max_rows; ++count) {
    const std::size_t in_a_row = (points + count - 1) / count;
    std::vector<PointRow> rows;
    for (std::size_t first = 0; first < points; first += in_a_row) {
      rows.emplace_back(column, field, first, in_a_row);
    }
    if (std::ranges::all_of(rows, [&](const PointRow& row) { return row.fits(column); })) {
      return rows;
    }
  }
  return {};
}

void add_rows(ScreenColumn& column, const std::vector<PointRow>& rows) {
  constexpr float between_rows = 0.3F;
  for (const PointRow& row : rows) {
    column.leave(&row != &rows.front() ? between_rows : 0.0F);
    row.add_to(column);
  }
}

void put_ring(ScreenColumn& column, bool is_chosen) {
  const float text_px = column.text_px();
  const Vec2 low(0.1F * text_px, column.bottom_px() + 0.1F * text_px);
  column.put_shape(Kind::disc, low, Vec2(0.8F * text_px), is_chosen ? Ink::chosen : Ink::outline,
                   (is_chosen ? 2.0F : 1.0F) * box_outline * text_px);
  if (is_chosen) {
    column.put_shape(Kind::disc, low + Vec2(0.2F * text_px), Vec2(0.4F * text_px), Ink::chosen);
  }
}

void add_list(ScreenColumn& column, const ScreenField& field) {
  constexpr float between_rows = 0.2F;
  for (std::size_t i = 0; i < field.labels.size(); ++i) {
    column.leave(i > 0 ? between_rows : 0.0F);
    const float top_px = column.bottom_px();
    put_ring(column, field.chosen == i);
    std::string label = field.labels[i];
    std::ranges::replace(label, '\n', ' ');
    column.write_between(1.4F * column.text_px(), column.width_px(), label, Align::left, Ink::text);
    if (field.has_focus && field.chosen.value_or(0) == i) {
      column.put_focus({0.0F, top_px}, {column.width_px(), column.bottom_px() - top_px});
    }
  }
}

void put_caret(ScreenColumn& column, const Vec2& low) {
  const float text_px = column.text_px();
  column.put_shape(Kind::box, low, {0.08F * text_px, text_px}, Ink::focus);
}

/// The end of a typed line that fits, as during typing.
std::string end_that_fits(const ScreenColumn& column, std::string line, float room_px) {
  while (column.line_width_px(line) > room_px) {
    line.erase(0, bytes_of_first(line, 1));
  }
  return line;
}

void add_typed_line(ScreenColumn& column, const ScreenField& field) {
  const float text_px = column.text_px();
  const Vec2 low = Vec2(box_padding * text_px, column.bottom_px() + box_padding * text_px);
  const float room_px = column.width_px() - (2.0F * box_padding + 0.2F) * text_px;
  const std::string line = end_that_fits(column, field.typed, room_px);
  column.put_line(low, line, TextFace::body, Ink::text);
  if (field.has_focus) {
    put_caret(column, low + Vec2(column.line_width_px(line) + 0.05F * text_px, 0.0F));
  }
  column.leave(box_height);
}

/// The last lines of typed text.
void add_typed_text(ScreenColumn& column, const ScreenField& field) {
  constexpr std::size_t shown_lines = 5;
  const float text_px = column.text_px();
  const float room_px = column.width_px() - (2.0F * box_padding + 0.2F) * text_px;
  std::vector<std::string> lines =
      wrap_to_width(field.typed, room_px, column.line_width(TextFace::body));
  if (lines.size() > shown_lines) {
    lines.erase(lines.begin(), lines.end() - shown_lines);
  }
  Vec2 low(box_padding * text_px, column.bottom_px() + box_padding * text_px);
  for (const std::string& line : lines) {
    column.put_line(low, line, TextFace::body, Ink::text);
    low.y += line_spacing * text_px;
  }
  if (field.has_focus) {
    const float width_px = column.line_width_px(lines.back());
    put_caret(column, low + Vec2(width_px + 0.05F * text_px, -line_spacing * text_px));
  }
  column.leave(line_spacing * shown_lines + 2.0F * box_padding);
}

void add_answer(ScreenColumn& column, const ScreenField& field) {
  switch (field.kind) {
    case ScreenField::Kind::scale:
      if (const std::vector<PointRow> rows = point_rows(column, field); !rows.empty()) {
        add_rows(column, rows);
        break;
      }
      [[fallthrough]];
    case ScreenField::Kind::choice:
      add_list(column, field);
      break;
    case ScreenField::Kind::line:
      add_typed_line(column, field);
      break;
    case ScreenField::Kind::text:
      add_typed_text(column, field);
      break;
  }
}

bool is_typed(const ScreenField& field) {
  return field.kind == ScreenField::Kind::line || field.kind == ScreenField::Kind::text;
}

/// Around the answer: thick and with an arrow if it has the focus, thin if it accepts typing.
void put_frame(ScreenColumn& column, const ScreenField& field, float top_px) {
  const float text_px = column.text_px();
  const float padding_px = is_typed(field) ? 0.0F : frame_padding * text_px;
  const Vec2 low(-padding_px, top_px - padding_px);
  const Vec2 size(column.width_px() + 2.0F * padding_px,
                  column.bottom_px() - top_px + 2.0F * padding_px);
  if (field.has_focus) {
    column.put_frame(low, size, Ink::focus, frame_outline * text_px);
    column.put_shape(Kind::triangle_right,
                     {low.x - 0.55F * text_px, low.y + 0.5F * (size.y - 0.7F * text_px)},
                     {0.4F * text_px, 0.7F * text_px}, Ink::focus);
  } else if (is_typed(field)) {
    column.put_frame(low, size, Ink::outline, box_outline * text_px);
  }
}

}  // namespace

void add_field(ScreenColumn& column, const ScreenField& field) {
  const float top_px = column.bottom_px();
  if (!field.question.empty()) {
    column.write(field.question, TextFace::body, Ink::text);
    column.leave(0.5F);
  }
  const float answer_top_px = column.bottom_px();
  add_answer(column, field);
  put_frame(column, field, answer_top_px);
  for (const auto& [words, ink] :
       {std::pair(&field.note, Ink::text), std::pair(&field.fault, Ink::fault)}) {
    if (!words->empty()) {
      column.leave(0.5F);
      column.write(*words, TextFace::body, ink);
    }
  }
  if (field.has_focus && !column.focus()) {
    column.put_focus({0.0F, top_px}, {column.width_px(), column.bottom_px() - top_px});
  }
}

}  // namespace foveola
