#include "analysis/publication/report/report_style.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "analysis/publication/figures/figure_drawing.h"

namespace foveola::analysis {
namespace {

using Colors = std::map<std::string, std::string>;

/// The custom properties between `begin` and the next brace.
Colors properties_after(const std::string& style, const std::string& begin) {
  const std::size_t start = style.find(begin) + begin.size();
  const std::string block = style.substr(start, style.find('}', start) - start);
  Colors colors;
  for (std::size_t at = block.find("--"); at != std::string::npos; at = block.find("--", at)) {
    const std::size_t colon = block.find(':', at);
    const std::size_t end = block.find(';', colon);
    colors[block.substr(at, colon - at)] = block.substr(colon + 2, end - colon - 2);
    at = end;
  }
  return colors;
}

Colors light() { return properties_after(std::string(report_style()), ":root {\n  color-scheme"); }

Colors dark() {
  return properties_after(std::string(report_style()), "(prefers-color-scheme: dark) {\n  :root {");
}

/// The relative luminance of "#rrggbb", as WCAG 2.2 defines it.
double luminance_of_hex(const std::string& color) {
  const long rgb = std::strtol(color.substr(1).c_str(), nullptr, 16);
  const auto linear = [](long byte) {
    const double value = static_cast<double>(byte & 0xff) / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(rgb >> 16) + 0.7152 * linear(rgb >> 8) + 0.0722 * linear(rgb);
}

/// The contrast ratio as WCAG 2.2 defines it, 1 to 21.
double contrast(const std::string& a, const std::string& b) {
  const auto [low, high] = std::minmax({luminance_of_hex(a), luminance_of_hex(b)});
  return (high + 0.05) / (low + 0.05);
}

struct Pair {
  const char* front;
  const char* back;
};

// What stands on what in the report; WCAG 2.2, success criteria 1.4.3 and 1.4.11, level AA.
constexpr double of_text = 4.5;
constexpr Pair texts[] = {{"--text", "--paper"},
                          {"--quiet", "--paper"},
                          {"--accent", "--paper"},
                          {"--text", "--notice"},
                          {"--figure-ink", "--paper"},
                          {"--figure-on-low-rating", "--figure-rating-1"},
                          {"--figure-on-low-rating", "--figure-rating-2"},
                          {"--figure-on-low-rating", "--figure-rating-3"},
                          {"--figure-on-high-rating", "--figure-rating-4"},
                          {"--figure-on-high-rating", "--figure-rating-5"}};
// Bars of ratings are edged with the ink.
constexpr double of_shapes = 3.0;
constexpr Pair shapes[] = {{"--flag", "--paper"},
                           {"--notice-rule", "--paper"},
                           {"--figure-method-1", "--paper"},
                           {"--figure-method-2", "--paper"},
                           {"--figure-method-3", "--paper"},
                           {"--figure-method-4", "--paper"},
                           {"--figure-method-5", "--paper"},
                           {"--figure-method-6", "--paper"}};

class ReportStyleContrast : public testing::TestWithParam<Colors (*)()> {};

TEST_P(ReportStyleContrast, TextIsReadable) {
  const Colors colors = GetParam()();
  for (const Pair& pair : texts) {
    EXPECT_GE(contrast(colors.at(pair.front), colors.at(pair.back)), of_text)
        << pair.front << " on " << pair.back;
  }
}

TEST_P(ReportStyleContrast, ShapesAreSeen) {
  const Colors colors = GetParam()();
  for (const Pair& pair : shapes) {
    EXPECT_GE(contrast(colors.at(pair.front), colors.at(pair.back)), of_shapes)
        << pair.front << " on " << pair.back;
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, ReportStyleContrast, testing::Values(light, dark));

TEST(ReportStyle, ContrastIsAsInTheRecommendation) {
  EXPECT_DOUBLE_EQ(contrast("#000000", "#ffffff"), 21.0);
  EXPECT_NEAR(contrast("#777777", "#ffffff"), 4.48, 0.005);
}

/// A colour that is written out instead of named would be the same in the dark.
TEST(ReportStyle, RulesTakeTheirColorsByName) {
  const std::string style(report_style());
  EXPECT_EQ(style.find('#', style.find("* { box-sizing")), std::string::npos);
}

}  // namespace
}  // namespace foveola::analysis
