// The letters of screens, as large as a window asks for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/window/letter_fonts.h"
#include "renderer/window/screen.h"
#include "renderer/window/screen_layout.h"

struct ImFont;
struct ImFontAtlas;

namespace foveola {

/// Where Debian keeps DejaVu Sans.
inline constexpr const char* dejavu_folder = "/usr/share/fonts/truetype/dejavu";

/// The characters of a text that no installed font has, or that screens cannot draw.
Characters characters_without_font(std::string_view text);

/// All that is written on a page.
Characters characters_of(const ScreenPage& page);

/// DejaVu Sans: Latin, Greek, Cyrillic, punctuation and arrows, and what else is asked for of it
/// and of other installed fonts. Other characters are shown as a question mark.
class ScreenFonts {
 public:
  /// Reads its files, by default where Debian keeps them. Throws Error if they are not there.
  explicit ScreenFonts(const std::filesystem::path& folder = dejavu_folder);

  /// Sees to it that the next atlas has these characters, if any font has them. Returns whether
  /// any of them is new.
  bool add_characters(const Characters& characters);

  /// Adds both faces to `atlas`, which must not outlive this, and is to be built before characters
  /// are added. text_px: a line's height.
  void add_to(ImFontAtlas& atlas, float text_px);

  // --- Once the atlas is built ---

  ImFont* face(TextFace face) const { return face == TextFace::title ? title_ : body_; }
  float height_px(TextFace face) const;
  /// Pixels from the left of the first letter to the right of the last.
  float width_px(TextFace face, std::string_view line) const;

 private:
  /// What another font than DejaVu Sans adds. An atlas refers to it where it is.
  struct OtherFont {
    LetterFont font;
    std::string file;
    std::vector<std::uint16_t> ranges;  ///< ranges of characters, in Dear ImGui's form
  };
  void add_other(const LetterFont& font);
  ImFont* add_face(ImFontAtlas& atlas, std::string& file, float height_px);

  std::filesystem::path folder_;
  std::string body_file_;
  std::string title_file_;
  Characters asked_for_;                   ///< beyond those that every atlas has
  std::vector<std::uint16_t> own_ranges_;  ///< the ranges of DejaVu Sans
  std::list<OtherFont> others_;
  ImFont* body_ = nullptr;
  ImFont* title_ = nullptr;
};

}  // namespace foveola
