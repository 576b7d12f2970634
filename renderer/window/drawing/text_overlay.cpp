#include "renderer/window/drawing/text_overlay.h"

#include <algorithm>

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace foveola {
namespace {

ImVec2 im(const Vec2& point) { return {point.x, point.y}; }

ImU32 im(Ink ink) {
  const Vec3 color = color_of(ink);
  return ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, 1.0F});
}

void paint_box(ImDrawList& list, const PlacedShape& shape) {
  if (shape.outline_px > 0.0F) {
    const Vec2 inset(0.5F * shape.outline_px);
    list.AddRect(im(shape.rect.low + inset), im(shape.rect.high - inset), im(shape.ink), 0.0F, 0,
                 shape.outline_px);
  } else {
    list.AddRectFilled(im(shape.rect.low), im(shape.rect.high), im(shape.ink));
  }
}

void paint_disc(ImDrawList& list, const PlacedShape& shape) {
  const Vec2 middle = 0.5F * (shape.rect.low + shape.rect.high);
  const float radius_px = 0.5F * (shape.rect.size().x - shape.outline_px);
  if (shape.outline_px > 0.0F) {
    list.AddCircle(im(middle), radius_px, im(shape.ink), 0, shape.outline_px);
  } else {
    list.AddCircleFilled(im(middle), radius_px, im(shape.ink));
  }
}

void paint(ImDrawList& list, const PlacedShape& shape) {
  const Vec2& low = shape.rect.low;
  const Vec2& high = shape.rect.high;
  const Vec2 middle = 0.5F * (low + high);
  switch (shape.kind) {
    case PlacedShape::Kind::box:
      paint_box(list, shape);
      break;
    case PlacedShape::Kind::disc:
      paint_disc(list, shape);
      break;
    case PlacedShape::Kind::triangle_up:
      list.AddTriangleFilled({middle.x, low.y}, im(high), {low.x, high.y}, im(shape.ink));
      break;
    case PlacedShape::Kind::triangle_down:
      list.AddTriangleFilled(im(low), {high.x, low.y}, {middle.x, high.y}, im(shape.ink));
      break;
    case PlacedShape::Kind::triangle_right:
      list.AddTriangleFilled(im(low), {high.x, middle.y}, {low.x, high.y}, im(shape.ink));
      break;
  }
}

void paint(ImDrawList& list, const ScreenLayout& layout, const ScreenFonts& fonts) {
  for (const PlacedShape& shape : layout.shapes) {
    paint(list, shape);
  }
  for (const PlacedText& text : layout.texts) {
    list.AddText(fonts.face(text.face), fonts.height_px(text.face), im(text.rect.low), im(text.ink),
                 text.line.data(), text.line.data() + text.line.size());
  }
}

/// From the minimum density to the maximum.
void paint_density_scale(ImDrawList& list, const Vec2& low, const Vec2& size) {
  constexpr int steps = 32;
  const Vec2 step(size.x / steps, size.y);
  const auto color = [](int at) {
    const Rgb heat = density_color(static_cast<float>(at) / steps);
    return ImGui::ColorConvertFloat4ToU32({heat.r, heat.g, heat.b, 1.0F});
  };
  for (int i = 0; i < steps; ++i) {
    const Vec2 left = low + Vec2(static_cast<float>(i) * step.x, 0.0F);
    list.AddRectFilledMultiColor(im(left), im(left + step), color(i), color(i + 1), color(i + 1),
                                 color(i));
  }
}

void paint(ImDrawList& list, const PlacedPanel& panel, const Vec2& letter_px) {
  list.AddRectFilled(im(panel.rect.low), im(panel.rect.high), IM_COL32(15, 15, 15, 170));
  Vec2 at = panel.rect.low + panel_padding_px;
  if (panel.has_density_scale) {
    const float width_px = panel.rect.size().x - 2.0F * panel_padding_px;
    paint_density_scale(list, at, {width_px, letter_px.y - 2.0F});
    at.y += letter_px.y;
  }
  for (const std::string& line : panel.lines) {
    list.AddText(ImGui::GetFont(), letter_px.y, im(at), IM_COL32_WHITE, line.data(),
                 line.data() + line.size());
    at.y += letter_px.y;
  }
}

/// The size of panels' monospaced letters, doubled where pixels are small.
Vec2 panel_letter_px(const ScreenRect& view) {
  constexpr float small_pixels_from = 1300.0F;  // for views this high
  const float scale = view.size().y >= small_pixels_from ? 2.0F : 1.0F;
  const ImVec2 letter = ImGui::CalcTextSize("0");
  return scale * Vec2(letter.x, letter.y);
}

ScreenPlace screen_place(const ShownView& view, int framebuffer_height) {
  if (!view.part_from_canvas) {
    return screen_place(view.part, framebuffer_height, view.straight_ahead);
  }
  ScreenPlace canvas = screen_place(view.part, framebuffer_height, Vec2(0.5F));
  // A background that also fills the part of an eye with an oblique view.
  const Vec2 beyond = 0.5F * canvas.view.size();
  canvas.view = {.low = canvas.view.low - beyond, .high = canvas.view.high + beyond};
  return canvas;
}

/// Moves the shapes from the vertex `first` on to their place in an eye's view.
void move_to_part(ImDrawList& list, int first, const Mat3& part_from_canvas,
                  const ScreenRect& part) {
  constexpr float nearest = 1e-3F;  // points beside or behind the eye go far outside its picture
  for (int i = first; i < list.VtxBuffer.Size; ++i) {
    ImVec2& corner = list.VtxBuffer[i].pos;
    const Vec2 place = (Vec2(corner.x, corner.y) - part.low) / part.size();
    const Vec3 seen = part_from_canvas * Vec3(place, 1.0F);
    corner = im(part.low + Vec2(seen) / std::max(seen.z, nearest) * part.size());
  }
}

void begin_frame(const IVec2& framebuffer) {
  ImGui::GetIO().DisplaySize = {static_cast<float>(framebuffer.x),
                                static_cast<float>(framebuffer.y)};
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
}

void end_frame() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace

TextOverlay::TextOverlay() {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().Fonts->Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  ImGui_ImplOpenGL3_Init("#version 330 core");
  ImGui_ImplOpenGL3_CreateDeviceObjects();
}

TextOverlay::~TextOverlay() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void TextOverlay::draw(const IVec2& framebuffer, std::span<const ShownView> views,
                       const Overlaid& overlaid) {
  if (overlaid.screen != nullptr && !views.empty()) {
    make_letters(text_height_px(screen_place(views.front(), framebuffer.y)), *overlaid.screen);
  }
  begin_frame(framebuffer);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (const ShownView& view : views) {
    if (overlaid.marks != nullptr) {
      paint(list, *overlaid.marks, view, framebuffer.y);
    }
  }
  for (const ShownView& view : views) {
    if (overlaid.screen != nullptr) {
      paint_screen(list, *overlaid.screen, view, framebuffer.y);
    }
  }
  for (const ShownView& view : views) {
    const ScreenRect pane = screen_place(view.part, framebuffer.y, std::nullopt).view;
    const Vec2 letter_px = panel_letter_px(pane);
    for (const PlacedPanel& panel : lay_out(overlaid.panels, pane, letter_px)) {
      paint(list, panel, letter_px);
    }
  }
  end_frame();
}

void TextOverlay::paint_screen(ImDrawList& list, const ScreenPage& screen, const ShownView& view,
                               int framebuffer_height) const {
  const TextWidth width_of = [this](TextFace face, std::string_view line) {
    return fonts_->width_px(face, line);
  };
  const int first = list.VtxBuffer.Size;
  paint(list, lay_out(screen, screen_place(view, framebuffer_height), width_of), *fonts_);
  if (view.part_from_canvas) {
    move_to_part(list, first, *view.part_from_canvas,
                 screen_place(view.part, framebuffer_height, std::nullopt).view);
  }
}

void TextOverlay::make_letters(float text_px, const ScreenPage& screen) {
  if (!fonts_) {
    fonts_.emplace();
  }
  const bool has_more = fonts_->add_characters(characters_of(screen));
  if (text_px == text_px_ && !has_more) {
    return;
  }
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.AddFontDefault();  // the font of panels
  fonts_->add_to(atlas, text_px);
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  text_px_ = text_px;
}

}  // namespace foveola
