#include "renderer/window/text_overlay.h"

#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

namespace foveola {
namespace {

constexpr ImGuiWindowFlags plain_panel =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings;

/// The anchor of a panel, both in a part of the window of unit size and in the panel itself.
ImVec2 anchor(PanelPlace place) {
  switch (place) {
    case PanelPlace::top_right:
      return {1.0F, 0.0F};
    case PanelPlace::middle:
      return {0.5F, 0.5F};
    case PanelPlace::bottom_left:
      return {0.0F, 1.0F};
    case PanelPlace::top_left:
      break;
  }
  return {0.0F, 0.0F};
}

void draw_panel(const std::string& name, const TextPanel& panel, const WindowPart& part,
                int framebuffer_height) {
  constexpr float margin_px = 8.0F;
  const ImVec2 at = anchor(panel.place);
  const float top = static_cast<float>(framebuffer_height - part.origin.y - part.size.y);
  const auto inner = [](int side) { return static_cast<float>(side) - 2.0F * margin_px; };
  ImGui::SetNextWindowPos(
      {static_cast<float>(part.origin.x) + margin_px + at.x * inner(part.size.x),
       top + margin_px + at.y * inner(part.size.y)},
      ImGuiCond_Always, at);
  ImGui::SetNextWindowBgAlpha(0.6F);
  ImGui::Begin(name.c_str(), nullptr, plain_panel);
  for (const std::string& line : panel.lines) {
    ImGui::TextUnformatted(line.c_str());
  }
  ImGui::End();
}

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

std::vector<ScreenPlace> screen_places(std::span<const ShownView> views, int framebuffer_height) {
  const bool is_headset = views.size() > 1;
  std::vector<ScreenPlace> places;
  for (const ShownView& view : views) {
    places.push_back(
        screen_place(view.part, framebuffer_height, is_headset, view.viewport.lens().axis));
  }
  return places;
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
  const std::vector<ScreenPlace> places =
      overlaid.screen != nullptr ? screen_places(views, framebuffer.y) : std::vector<ScreenPlace>();
  if (!places.empty()) {
    make_letters(text_height_px(places.front()), *overlaid.screen);
  }
  begin_frame(framebuffer);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (const ShownView& view : views) {
    if (overlaid.marks != nullptr) {
      paint(list, *overlaid.marks, view, framebuffer.y);
    }
  }
  for (const ScreenPlace& place : places) {
    const TextWidth width_of = [this](TextFace face, std::string_view line) {
      return fonts_->width_px(face, line);
    };
    paint(list, lay_out(*overlaid.screen, place, width_of), *fonts_);
  }
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (std::size_t k = 0; k < overlaid.panels.size(); ++k) {
      draw_panel(fmt::format("panel {} of view {}", k, i), overlaid.panels[k], views[i].part,
                 framebuffer.y);
    }
  }
  end_frame();
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
  atlas.AddFontDefault();  // the panels'
  fonts_->add_to(atlas, text_px);
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
  text_px_ = text_px;
}

}  // namespace foveola
