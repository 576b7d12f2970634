// Which of the installed fonts have the letters that the screens' own font lacks.
#pragma once

#include <filesystem>
#include <set>
#include <string_view>
#include <vector>

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

}  // namespace foveola
