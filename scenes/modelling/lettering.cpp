#include "scenes/modelling/lettering.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "scenes/modelling/curve.h"

namespace foveola::scenes {
namespace {

/// Strokes are pairs of digits, x and y, parted by spaces: the baseline is y = 2, a small letter
/// ends at 5 and a capital at 8. A stroke that begins with '-' has corners, others are curves.
struct Glyph {
  char letter;
  std::string_view strokes;
};

constexpr std::array glyphs = {
    Glyph{'a', "35150403122233 -3532"},
    Glyph{'b', "-0802 0415253433221203"},
    Glyph{'c', "3425150403122233"},
    Glyph{'d', "35150403122233 -3832"},
    Glyph{'e', "-0434 34251504031222 -2233"},
    Glyph{'f', "38281712 -0525"},
    Glyph{'g', "35150403122233 3531201001"},
    Glyph{'h', "-0802 0415253432"},
    Glyph{'i', "-1512 -1716"},
    Glyph{'j', "25211001 -2726"},
    Glyph{'k', "-0802 -3503 -1432"},
    Glyph{'l', "181322"},
    Glyph{'m', "-0502 04152422 24354442"},
    Glyph{'n', "-0502 0415253432"},
    Glyph{'o', "150403122233342515"},
    Glyph{'p', "-0500 0415253433221203"},
    Glyph{'q', "35150403122233 -3530"},
    Glyph{'r', "-0502 041525"},
    Glyph{'s', "351504332202"},
    Glyph{'t', "17132232 -0525"},
    Glyph{'u', "0503122233 -3532"},
    Glyph{'v', "-052245"},
    Glyph{'w', "-0512243245"},
    Glyph{'x', "-0532 -3502"},
    Glyph{'y', "-0522 -4510"},
    Glyph{'z', "-05350232"},
    Glyph{'A', "-022842 -1434"},
    Glyph{'B', "-0208 082837362505 2544433202"},
    Glyph{'C', "4738180604123243"},
    Glyph{'D', "-0208 082846442202"},
    Glyph{'E', "-48080242 -0535"},
    Glyph{'F', "-480802 -0535"},
    Glyph{'G', "4738180604123244 -4424"},
    Glyph{'H', "-0802 -4842 -0545"},
    Glyph{'I', "-1812"},
    Glyph{'J', "3834221203"},
    Glyph{'K', "-0802 -4804 -1542"},
    Glyph{'L', "-080242"},
    Glyph{'M', "-0208254842"},
    Glyph{'N', "-02084248"},
    Glyph{'O', "180604123244463818"},
    Glyph{'P', "-0208 083847463505"},
    Glyph{'Q', "180604123244463818 -2442"},
    Glyph{'R', "-0208 083847463505 -2542"},
    Glyph{'S', "4738180715354443321203"},
    Glyph{'T', "-0848 -2822"},
    Glyph{'U', "080412324448"},
    Glyph{'V', "-082248"},
    Glyph{'W', "-0812253248"},
    Glyph{'X', "-0842 -0248"},
    Glyph{'Y', "-0825 -4825 -2522"},
    Glyph{'Z', "-08480242"},
    Glyph{'0', "180604122234362818"},
    Glyph{'1', "-062822"},
    Glyph{'2', "071828373602 -0232"},
    Glyph{'3', "071828373615 153433221203"},
    Glyph{'4', "-280444 -3632"},
    Glyph{'5', "-380805 05253433221202"},
    Glyph{'6', "38170503122233342504"},
    Glyph{'7', "-083812"},
    Glyph{'8', "15060718283736251504031222333425"},
    Glyph{'9', "362515060718283722"},
    Glyph{'+', "-0545 -2327"},
    Glyph{'-', "-0535"},
    Glyph{'=', "-0646 -0444"},
    Glyph{'.', "-1213"},
    Glyph{',', "-1301"},
    Glyph{':', "-1312 -1615"},
    Glyph{'/', "-0248"},
    Glyph{'(', "28161422"},
    Glyph{')', "08161402"},
    Glyph{'?', "071828373514 -1312"},
    Glyph{'!', "-1814 -1312"},
};

constexpr double baseline = 2.0;
constexpr double space_width = 3.0;
constexpr double gap = 1.4;

Stroke stroke_from(std::string_view digits) {
  const bool has_corners = digits.front() == '-';
  digits.remove_prefix(has_corners ? 1 : 0);
  Stroke points;
  for (; digits.size() >= 2; digits.remove_prefix(2)) {
    points.emplace_back(digits[0] - '0', digits[1] - '0' - baseline);
  }
  return has_corners ? points : curve<DVec2>(points, 5);
}

std::vector<Stroke> strokes_from(std::string_view text) {
  std::vector<Stroke> strokes;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    strokes.push_back(stroke_from(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return strokes;
}

}  // namespace

Lettering lettering(std::string_view text) {
  Lettering result;
  for (const char letter : text) {
    const auto* const glyph =
        std::find_if(glyphs.begin(), glyphs.end(),
                     [&](const Glyph& candidate) { return candidate.letter == letter; });
    if (glyph == glyphs.end()) {
      result.width += space_width;
      continue;
    }
    double right = 0.0;
    for (Stroke& stroke : strokes_from(glyph->strokes)) {
      for (DVec2& point : stroke) {
        right = std::max(right, point.x);
        point.x += result.width;
      }
      result.strokes.push_back(std::move(stroke));
    }
    result.width += right + gap;
  }
  return result;
}

}  // namespace foveola::scenes
