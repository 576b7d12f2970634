// The fonts of screens, at a window's size.
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

/// All characters of a text in UTF-8, except line breaks and other controls.
Characters characters_of(std::string_view text);

/// The wanted characters that the font file at `path` has and screens can draw, up to U+FFFF; empty
/// if it cannot be read.
Characters characters_in_font(const std::filesystem::path& path, const Characters& wanted);

/// A face of a font file.
struct LetterFont {
  std::filesystem::path path;
  int face = 0;  ///< index in a collection of faces
  Characters characters;
};

/// Fonts with the wanted characters, by fontconfig: each character in one font, in as few fonts as
/// its first choice allows. Characters without any font are left out.
std::vector<LetterFont> fonts_for(const Characters& wanted);

/// Debian's folder of DejaVu Sans.
inline constexpr const char* dejavu_folder = "/usr/share/fonts/truetype/dejavu";

/// The characters of a text without an installed font, or that screens cannot draw.
Characters characters_without_font(std::string_view text);

/// All characters on a page.
Characters characters_of(const ScreenPage& page);

/// DejaVu Sans: Latin, Greek, Cyrillic, punctuation and arrows, and requested characters from it
/// and other installed fonts. Other characters are shown as a question mark.
class ScreenFonts {
 public:
  /// Reads the font files, by default from Debian's folder. Throws Error if they do not exist.
  explicit ScreenFonts(const std::filesystem::path& folder = dejavu_folder);

  /// Includes these characters in the next atlas, if a font has them. Returns whether any is new.
  bool add_characters(const Characters& characters);

  /// Adds both faces to `atlas`, which must not outlive this, and must be built before characters
  /// are added. text_px: a line's height.
  void add_to(ImFontAtlas& atlas, float text_px);

  // --- Once the atlas is built ---

  ImFont* face(TextFace face) const { return face == TextFace::title ? title_ : body_; }
  float height_px(TextFace face) const;
  /// Pixels from the left of the first letter to the right of the last.
  float width_px(TextFace face, std::string_view line) const;

 private:
  /// A font besides DejaVu Sans. An atlas refers to it in place.
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
  Characters asked_for_;                   ///< beyond those of every atlas
  std::vector<std::uint16_t> own_ranges_;  ///< the ranges of DejaVu Sans
  std::list<OtherFont> others_;
  ImFont* body_ = nullptr;
  ImFont* title_ = nullptr;
};

}  // namespace foveola
