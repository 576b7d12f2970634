#include "renderer/window/screens/screen_fonts.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include <fontconfig/fontconfig.h>
#include <imgui.h>

#include "renderer/base/error.h"
#include "renderer/base/files/files.h"

namespace foveola {
namespace {

using Pattern = std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)>;
using CharSet = std::unique_ptr<FcCharSet, decltype(&FcCharSetDestroy)>;
using FontSet = std::unique_ptr<FcFontSet, decltype(&FcFontSetDestroy)>;
using Config = std::unique_ptr<FcConfig, decltype(&FcConfigDestroy)>;

constexpr char32_t last_drawable = 0xFFFF;  // limit of Dear ImGui in Debian's build

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

/// Whether Dear ImGui supports the font: outlines of one colour.
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

/// All fonts, the best matches first: upright, regular, sans serif, with these characters.
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

/// First and last characters, and a zero at the end, as Dear ImGui requires.
constexpr std::array<ImWchar, 19> known_letters = {
    0x0020, 0x024F,  // Latin
    0x0370, 0x03FF,  // Greek
    0x0400, 0x04FF,  // Cyrillic
    0x1E00, 0x1EFF,  // Latin of Vietnamese and others
    0x2010, 0x205F,  // punctuation
    0x20A0, 0x20BF,  // currencies
    0x2190, 0x21FF,  // arrows
    0x2212, 0x2215,  // minus and others
    0xFFFD, 0xFFFD,  // replacement of missing characters
    0,
};

constexpr const char* body_name = "DejaVuSans.ttf";
constexpr const char* title_name = "DejaVuSans-Bold.ttf";

std::string read_font(const std::filesystem::path& path) {
  try {
    return read_file(path);
  } catch (const Error&) {
    throw Error(path.string(), "this font, with which screens are written, cannot be read",
                "install Debian's package fonts-dejavu-core");
  }
}

bool is_known(char32_t character) {
  for (std::size_t i = 0; i + 1 < known_letters.size(); i += 2) {
    if (character >= known_letters[i] && character <= known_letters[i + 1]) {
      return true;
    }
  }
  return false;
}

/// The characters that are not in every atlas.
Characters unknown_of(const Characters& characters) {
  Characters unknown;
  std::ranges::copy_if(characters, std::inserter(unknown, unknown.end()),
                       [](char32_t character) { return !is_known(character); });
  return unknown;
}

Characters without(const Characters& all, const Characters& taken) {
  Characters rest;
  std::set_difference(all.begin(), all.end(), taken.begin(), taken.end(),
                      std::inserter(rest, rest.end()));
  return rest;
}

/// Characters that can be drawn: first and last of each range, and a zero at the end.
std::vector<std::uint16_t> ranges_of(const Characters& characters) {
  std::vector<std::uint16_t> ranges;
  for (const char32_t character : characters) {
    ranges.insert(ranges.end(), 2, static_cast<std::uint16_t>(character));
  }
  ranges.push_back(0);
  return ranges;
}

/// The ranges of an atlas's own letters and some more.
std::vector<std::uint16_t> known_letters_and(const Characters& characters) {
  std::vector<std::uint16_t> ranges(known_letters.begin(), known_letters.end() - 1);
  const std::vector<std::uint16_t> more = ranges_of(characters);
  ranges.insert(ranges.end(), more.begin(), more.end());
  return ranges;
}

ImFontConfig screen_letters() {
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 1;
  config.PixelSnapH = true;
  return config;
}

ImFont* add_font(ImFontAtlas& atlas, std::string& file, float height_px,
                 const std::vector<std::uint16_t>& ranges, const ImFontConfig& config) {
  return atlas.AddFontFromMemoryTTF(file.data(), static_cast<int>(file.size()), height_px, &config,
                                    ranges.data());
}

}  // namespace

Characters characters_without_font(std::string_view text) {
  const Characters unknown = unknown_of(characters_of(text));
  Characters missing = without(
      unknown, characters_in_font(std::filesystem::path(dejavu_folder) / body_name, unknown));
  for (const LetterFont& font : fonts_for(missing)) {
    missing = without(missing, font.characters);
  }
  return missing;
}

Characters characters_of(const ScreenPage& page) {
  Characters all;
  const auto add = [&](std::string_view text) { all.merge(characters_of(text)); };
  add(page.title);
  add(page.keys);
  std::ranges::for_each(page.paragraphs, add);
  for (const ScreenField& field : page.fields) {
    add(field.question);
    add(field.typed);
    add(field.note);
    add(field.fault);
    std::ranges::for_each(field.labels, add);
  }
  return all;
}

ScreenFonts::ScreenFonts(const std::filesystem::path& folder)
    : folder_(folder),
      body_file_(read_font(folder / body_name)),
      title_file_(read_font(folder / title_name)),
      own_ranges_(known_letters_and({})) {}

bool ScreenFonts::add_characters(const Characters& characters) {
  const Characters new_ones = without(unknown_of(characters), asked_for_);
  if (new_ones.empty()) {
    return false;
  }
  asked_for_.insert(new_ones.begin(), new_ones.end());
  const Characters own = characters_in_font(folder_ / body_name, asked_for_);
  own_ranges_ = known_letters_and(own);
  for (const LetterFont& font : fonts_for(without(new_ones, own))) {
    add_other(font);
  }
  return true;
}

void ScreenFonts::add_other(const LetterFont& font) {
  auto other = std::ranges::find_if(others_, [&](const OtherFont& known) {
    return known.font.path == font.path && known.font.face == font.face;
  });
  if (other == others_.end()) {
    other = others_.insert(other, {.font = font, .file = read_font(font.path), .ranges = {}});
  }
  other->font.characters.insert(font.characters.begin(), font.characters.end());
  other->ranges = ranges_of(other->font.characters);
}

void ScreenFonts::add_to(ImFontAtlas& atlas, float text_px) {
  body_ = add_face(atlas, body_file_, text_px);
  title_ = add_face(atlas, title_file_, std::round(title_scale * text_px));
}

ImFont* ScreenFonts::add_face(ImFontAtlas& atlas, std::string& file, float height_px) {
  ImFont* const face = add_font(atlas, file, height_px, own_ranges_, screen_letters());
  for (OtherFont& other : others_) {
    ImFontConfig config = screen_letters();
    config.MergeMode = true;
    config.FontNo = other.font.face;
    add_font(atlas, other.file, height_px, other.ranges, config);
  }
  return face;
}

float ScreenFonts::height_px(TextFace face_wanted) const { return face(face_wanted)->FontSize; }

float ScreenFonts::width_px(TextFace face_wanted, std::string_view line) const {
  const ImFont* font = face(face_wanted);
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0F, line.data(), line.data() + line.size())
      .x;
}

Characters characters_of(std::string_view text) {
  constexpr char32_t first_printable = 0x20;
  Characters characters;
  while (!text.empty()) {
    FcChar32 character = 0;
    const int bytes = FcUtf8ToUcs4(reinterpret_cast<const FcChar8*>(text.data()), &character,
                                   static_cast<int>(text.size()));
    if (bytes <= 0) {
      break;  // not UTF-8; reported by its reader
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
