// The letters of screens, as large as a window asks for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/window/screens/screen.h"
#include "renderer/window/screens/screen_layout.h"

struct ImFont;
struct ImFontAtlas;
namespace foveola {

/// Unicode code points.
using Characters = std::set<char32_t>;

/// All of a text in UTF-8 but line breaks and other controls.
Characters characters_of(std::string_view text);

/// Those that the font file at `path` has and screens can draw, which is none beyond U+FFFF; empty
/// if it cannot be read.
Characters characters_in_font(const std::filesystem::path& path, const Characters& wanted);

/// A face of a font file.
struct LetterFont {
  std::filesystem::path path;
  int face = 0;  ///< index in a collection of faces
  Characters characters;
};

/// Fonts that have the wanted characters, by fontconfig, each character in one of them: in as few
/// fonts as its first choice allows. What no font has is in none of them.
std::vector<LetterFont> fonts_for(const Characters& wanted);

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
