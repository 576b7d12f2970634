#include "analysis/tables/latex.h"

#include "tests/matchers.h"

namespace foveola::analysis {
namespace {

TEST(LatexText, NamesCannotBecomeCommands) {
  EXPECT_EQ(latex_text("a_b & 50 % of #1 {x} $y$ ~^\\input"),
            "a\\_b \\& 50 \\% of \\#1 \\{x\\} \\$y\\$ \\~{}\\^{}\\textbackslash{}input");
  EXPECT_EQ(latex_text("keine & 0 % <b>"), "keine \\& 0 \\% \\textless{}b\\textgreater{}");
  EXPECT_EQ(latex_text("über_all \"日本\""), "über\\_all ``日本''");
  EXPECT_EQ(latex_text("(\"a\") 5\" x"), "(``a'') 5'' x");
  EXPECT_EQ(latex_text("a\nb|c\x7f"), "a b\\textbar{}c?");
}

TEST(LatexText, SymbolsOfStatisticsAreTypeset) {
  EXPECT_EQ(latex_text("1 ± 2, –"), "1 $\\pm$ 2, --");
  EXPECT_EQ(latex_text("η² χ² ρ ε 3 × 4 − 1°"),
            "$\\eta$$^2$ $\\chi$$^2$ $\\rho$ $\\epsilon$ 3 $\\times$ 4 $-$ 1$^\\circ$");
}

TEST(LatexText, LongNamesCanBeBroken) {
  EXPECT_EQ(latex_text("a_b a_name_of_many_letters"),
            "a\\_b a\\_\\allowbreak{}name\\_\\allowbreak{}of\\_\\allowbreak{}many\\_\\allowbreak{}"
            "letters");
  EXPECT_EQ(latex_text("a/b halls_and/rooms/of.glb"),
            "a/b halls\\_\\allowbreak{}and/\\allowbreak{}rooms/\\allowbreak{}of.glb");
}

TEST(LatexText, GreekLettersAreTypeset) {
  EXPECT_EQ(latex_text("αΩ"), "$\\alpha$$\\Omega$");
  EXPECT_EQ(latex_text("Χο"), "Xo");
}

TEST(LatexText, OnlyHyphensBeforeNumbersAreMinusSigns) {
  EXPECT_EQ(latex_text("-0.4 [-1, 0]"), "$-$0.4 [$-$1, 0]");
  EXPECT_EQ(latex_text("scene-1 - a"), "scene-1 - a");
  EXPECT_EQ(latex_text("a--b---c"), "a-{}-{}b-{}-{}-c");
}

TEST(LatexText, SmallNumbersAreWrittenAsPowersOfTen) {
  EXPECT_EQ(latex_text("3.3e-05"), "$3.3 \\times 10^{-5}$");
  EXPECT_EQ(latex_text("< 1e-300"), "$< 10^{-300}$");
  EXPECT_EQ(latex_text("0.031"), "0.031");
  EXPECT_EQ(latex_text("e-5"), "e-5");
  EXPECT_EQ(latex_text("scene 1e"), "scene 1e");
  for (const char* name : {"1e-", "1e+e", "1ee", "1e99999999999", "-e-5", "<e5", "1 e5"}) {
    EXPECT_EQ(latex_text(name).find("times"), std::string::npos) << name;
  }
}

TEST(LatexNeeds, DependOnItsLetters) {
  const std::string packages = "% Needs \\usepackage{array,booktabs,graphicx}.\n";
  EXPECT_EQ(latex_needs("a $\\pm$ b"), packages);
  EXPECT_THAT(latex_needs("łą é"), HasSubstr("[T1]{fontenc}"));
  EXPECT_THAT(latex_needs("日本 é"), HasSubstr("LuaLaTeX"));
  EXPECT_TRUE(latex_needs("日本").starts_with(packages));
}

}  // namespace
}  // namespace foveola::analysis
