#include "renderer/window/text_overlay.h"

#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

namespace foveola {
namespace {

constexpr ImGuiWindowFlags plain_panel =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings;

/// Where in a part of unit size a panel stands, which is also the point of it that stands there.
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

}  // namespace

TextOverlay::TextOverlay() {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

TextOverlay::~TextOverlay() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void TextOverlay::draw(const IVec2& framebuffer, std::span<const WindowPart> parts,
                       std::span<const TextPanel> panels) {
  if (panels.empty()) {
    return;
  }
  ImGui::GetIO().DisplaySize = {static_cast<float>(framebuffer.x),
                                static_cast<float>(framebuffer.y)};
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t k = 0; k < panels.size(); ++k) {
      draw_panel(fmt::format("panel {} of view {}", k, i), panels[k], parts[i], framebuffer.y);
    }
  }
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace foveola
