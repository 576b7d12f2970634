#include "renderer/window/letter_fonts.h"

#include <memory>
#include <utility>

#include <fontconfig/fontconfig.h>

namespace foveola {
namespace {

using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;
using CharSet = std::unique_ptr<FcCharSet, decltype(&FcCharSetDestroy)>;
using FontSet = std::unique_ptr<FcFontSet, decltype(&FcFontSetDestroy)>;
using Config = std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)>;

constexpr char32_t last_drawable = 0xFFFF;  // Dear ImGui as Debian builds it

Characters covered_by(const FcPattern& font, const Characters& wanted) {
  FcCharSet* has = nullptr;
  Characters covered;
  if (FcPatternGetCharSet(&font, FC_CHARSET, 0, &has) == FcResultMatch) {
    for (const char32_t character : wanted) {
      if (character <= last_drawable && FcCharSetHasChar(has, character) == FcTrue) {
        covered.insert(character);
      }
    }
  }
  return covered;
}

/// Whether Dear ImGui can read it: outlines of one colour.
bool is_drawable(const FcPattern& font) {
  FcChar8* format = nullptr;
  FcBool has_outlines = FcFalse;
  FcBool has_color = FcFalse;
  FcPatternGetBool(&font, FC_OUTLINE, 0, &has_outlines);
  FcPatternGetBool(&font, FC_COLOR, 0, &has_color);
  if (FcPatternGetString(&font, FC_FONTFORMAT, 0, &format) != FcResultMatch) {
    return false;
  }
  const std::string_view name(reinterpret_cast<const char*>(format));
  return has_outlines == FcTrue && has_color == FcFalse && (name == "TrueType" || name == "CFF");
}

/// All fonts, those that fit best first: upright, regular, without serifs, with these characters.
FontSet sorted_fonts(FcConfig& config, const Characters& wanted) {
  const CharSet characters(FcCharSetCreate(), &FcCharSetDestroy);
  for (const char32_t character : wanted) {
    FcCharSetAddChar(characters.get(), character);
  }
  const Pattern pattern(FcPatternCreate(), &FcPatternDestroy);
  FcPatternAddCharSet(pattern.get(), FC_CHARSET, characters.get());
  FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
  FcConfigSubstitute(&config, pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  FcResult result = FcResultMatch;
  return {FcFontSort(&config, pattern.get(), FcFalse, nullptr, &result), &FcFontSetDestroy};
}

LetterFont letter_font(const FcPattern& font, Characters characters) {
  FcChar8* path = nullptr;
  int face = 0;
  FcPatternGetString(&font, FC_FILE, 0, &path);
  FcPatternGetInteger(&font, FC_INDEX, 0, &face);
  return {.path = reinterpret_cast<const char*>(path),
          .face = face & 0xFFFF,  // above it: a variable font's instance
          .characters = std::move(characters)};
}

}  // namespace

Characters characters_of(std::string_view text) {
  constexpr char32_t first_printable = 0x20;
  Characters characters;
  while (!text.empty()) {
    FcChar32 character = 0;
    const int bytes = FcUtf8ToUcs4(reinterpret_cast<const FcChar8*>(text.data()), &character,
                                   static_cast<int>(text.size()));
    if (bytes <= 0) {
      break;  // no UTF-8; whoever read it has said so
    }
    if (character >= first_printable) {
      characters.insert(character);
    }
    text.remove_prefix(static_cast<std::size_t>(bytes));
  }
  return characters;
}

Characters characters_in_font(const std::filesystem::path& path, const Characters& wanted) {
  int faces = 0;
  const Pattern font(
      FcFreeTypeQuery(reinterpret_cast<const FcChar8*>(path.c_str()), 0, nullptr, &faces),
      &FcPatternDestroy);
  return font != nullptr ? covered_by(*font, wanted) : Characters{};
}

std::vector<LetterFont> fonts_for(const Characters& wanted) {
  Characters missing = wanted;
  std::vector<LetterFont> fonts;
  const Config config(missing.empty() ? nullptr : FcInitLoadConfigAndFonts(), &FcConfigDestroy);
  if (config == nullptr) {
    return fonts;
  }
  const FontSet sorted = sorted_fonts(*config, missing);
  for (int i = 0; sorted != nullptr && i < sorted->nfont && !missing.empty(); ++i) {
    const FcPattern& font = *sorted->fonts[i];
    const Characters covered = is_drawable(font) ? covered_by(font, missing) : Characters{};
    if (!covered.empty()) {
      fonts.push_back(letter_font(font, covered));
      std::erase_if(missing, [&](char32_t character) { return covered.contains(character); });
    }
  }
  return fonts;
}

}  // namespace foveola
