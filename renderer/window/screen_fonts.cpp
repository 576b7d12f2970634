#include "renderer/window/screen_fonts.h"

#include <array>
#include <cfloat>
#include <cmath>

#include <imgui.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace foveola {
namespace {

/// First and last characters, and a zero at the end, as Dear ImGui asks.
constexpr std::array<ImWchar, 19> known_letters = {
    0x0020, 0x024F,  // Latin
    0x0370, 0x03FF,  // Greek
    0x0400, 0x04FF,  // Cyrillic
    0x1E00, 0x1EFF,  // Latin of Vietnamese and others
    0x2010, 0x205F,  // punctuation
    0x20A0, 0x20BF,  // currencies
    0x2190, 0x21FF,  // arrows
    0x2212, 0x2215,  // minus and others
    0xFFFD, 0xFFFD,  // stands for what is not here
    0,
};

std::string read_font(const std::filesystem::path& path) {
  try {
    return read_file(path);
  } catch (const Error&) {
    throw Error(path.string(), "this font, with which screens are written, cannot be read",
                "install Debian's package fonts-dejavu-core");
  }
}

ImFont* add_face(ImFontAtlas& atlas, std::string& file, float height_px) {
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 1;
  config.PixelSnapH = true;
  return atlas.AddFontFromMemoryTTF(file.data(), static_cast<int>(file.size()), height_px, &config,
                                    known_letters.data());
}

}  // namespace

ScreenFonts::ScreenFonts(const std::filesystem::path& folder)
    : body_file_(read_font(folder / "DejaVuSans.ttf")),
      title_file_(read_font(folder / "DejaVuSans-Bold.ttf")) {}

void ScreenFonts::add_to(ImFontAtlas& atlas, float text_px) {
  body_ = add_face(atlas, body_file_, text_px);
  title_ = add_face(atlas, title_file_, std::round(title_scale * text_px));
}

float ScreenFonts::height_px(TextFace face_wanted) const { return face(face_wanted)->FontSize; }

float ScreenFonts::width_px(TextFace face_wanted, std::string_view line) const {
  const ImFont* font = face(face_wanted);
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0F, line.data(), line.data() + line.size())
      .x;
}

}  // namespace foveola
