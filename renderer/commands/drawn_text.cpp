#include "renderer/commands/drawn_text.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>
#include <imgui_internal.h>

namespace foveola {

struct TextDrawing::Font {
  ImFontAtlas atlas;
  const ImFont* font = nullptr;
  const unsigned char* coverage = nullptr;  ///< of the atlas's pixels, from 0 to 255
  IVec2 size{0};

  Font() : font(atlas.AddFontDefault()) {
    unsigned char* pixels = nullptr;
    atlas.GetTexDataAsAlpha8(&pixels, &size.x, &size.y);
    coverage = pixels;
  }

  float coverage_at(int x, int y) const {
    return static_cast<float>(coverage[static_cast<std::size_t>(y) * size.x + x]) / 255.0F;
  }
};

namespace {

bool is_inside(const RgbImage& image, int x, int y) {
  return x >= 0 && y >= 0 && x < image.width && y < image.height;
}

}  // namespace

TextDrawing::TextDrawing() : font_(std::make_unique<Font>()) {}

TextDrawing::~TextDrawing() = default;

void TextDrawing::draw(const std::string& text, const IVec2& corner, int width,
                       RgbImage& image) const {
  float advance = 0.0F;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at < end;) {
    unsigned int letter = 0;
    at += std::max(1, ImTextCharFromUtf8(&letter, at, end));
    const ImFontGlyph* const glyph = font_->font->FindGlyph(static_cast<ImWchar>(letter));
    if (glyph == nullptr || advance + glyph->AdvanceX > static_cast<float>(width)) {
      return;
    }
    const IVec2 from(std::lround(glyph->U0 * static_cast<float>(font_->size.x)),
                     std::lround(glyph->V0 * static_cast<float>(font_->size.y)));
    const IVec2 to(corner.x + std::lround(advance + glyph->X0), corner.y + std::lround(glyph->Y0));
    for (int y = 0; y < std::lround(glyph->Y1 - glyph->Y0); ++y) {
      for (int x = 0; x < std::lround(glyph->X1 - glyph->X0); ++x) {
        if (is_inside(image, to.x + x, to.y + y)) {
          Rgb& pixel = image.at(to.x + x, to.y + y);
          pixel = glm::mix(pixel, Rgb(1.0F), font_->coverage_at(from.x + x, from.y + y));
        }
      }
    }
    advance += glyph->AdvanceX;
  }
}

}  // namespace foveola
